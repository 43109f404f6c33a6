#include "exact/base/sha256.h"

#include <openssl/evp.h>

#include <array>
#include <cstdio>

#include "exact/base/failure.h"

namespace tribunal {

std::string sha256(std::string_view bytes) {
  std::array<unsigned char, 32> digest{};
  if (EVP_Digest(bytes.data(), bytes.size(), digest.data(), nullptr, EVP_sha256(), nullptr) != 1) {
    throw Failure(Exit::resources, "libcrypto has no SHA-256");
  }
  std::string hex;
  for (const unsigned char byte : digest) {
    char two[3];
    std::snprintf(two, sizeof two, "%02x", byte);
    hex += two;
  }
  return hex;
}

}  // namespace tribunal
