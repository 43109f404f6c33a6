// A user of the installed package: the Segura–Feito test from the headers, and a method by name.
#include <iostream>

#include "core/kernel.h"
#include "core/segura_feito.h"
#include "exact/methods/methods.h"

int main() {
  using namespace tribunal;
  const Segment segment{{1, 1, -1}, {1, 1, 1}};
  const Triangle triangle{{0, 0, 0}, {4, 0, 0}, {0, 4, 0}};
  const Answer exact = find_method("sf-rational")->segment(segment, triangle);
  std::cout << "float: " << (segura_feito(segment, triangle, FormulaKernel<float>()).hit ? "hit" : "miss")
            << ", sf-rational: " << (exact.hit ? "hit" : "miss") << " at " << name_of(exact.contact) << "\n";
}
