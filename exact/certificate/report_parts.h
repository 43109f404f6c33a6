// What the writers of a certificate share.
#pragma once

#include <functional>
#include <map>
#include <string>
#include <vector>

#include "exact/certificate/certificate.h"

namespace tribunal {

inline constexpr Format both_formats[] = {Format::binary64, Format::binary32};

inline const char* probes_word(bool of_rays) { return of_rays ? "ray" : "segment"; }

// --- words: report_words.cpp -----------------------------------------------------------------------------------------

/// The certificate for people: each text in it, which is what a log says and may be anything, made by the door to a
/// terminal or to Markdown.
Certificate with_texts(const Certificate& c, std::string (*door)(std::string_view));

/// "binary64: 2 of 3 refused; 1 ANSWERED, the first is nan-1"
std::string in_words(const NonfiniteRow& row);

/// The share of wrong answers; "-" where nothing was judged.
std::string rate_in_words(const Count& count);

/// "classes", or "outcomes" of polygons.
const char* classes_word(const Certificate& c);

/// Nothing, or the text after a semicolon.
std::string after_semicolon(const std::string& text);

/// "1 wrong of 12 (8.33 %); 3 outside the contract; 2 refused": each case once. And the same with what the wrong
/// answers are.
std::string wrong_of(const Count& count);
std::string with_breakdown(const Count& count);

/// Of all strata of a stream.
Count total_of(const Certificate& c, std::size_t stream);

std::string coverage_text(const Certificate& c);

/// One line a fault, each with this before it.
std::string fault_lines(const Certificate& c, const std::string& before);

/// The strata with the most wrong answers, of these.
std::vector<Stratum> worst_of(const Certificate& c, std::size_t most, const std::function<bool(const Stratum&)>& among);

// --- sections of the Markdown, lines of the summary ------------------------------------------------------------------

std::string relations_section(const Certificate& c);
std::string errors_section(const Certificate& c);

/// One line a population, and one for each relation broken.
std::string relation_lines(const Certificate& c);

/// One line for each number and format.
std::string errors_lines(const Certificate& c);

// --- for JSON as well ------------------------------------------------------------------------------------------------

/// What it was made with.
Json environment_json(const Certificate& c);

}  // namespace tribunal
