#include "exact/base/plain_locale.h"

#include <locale.h>  // uselocale is POSIX's

#include <clocale>

namespace tribunal {

void use_plain_locale() {
  static const locale_t plain = newlocale(LC_ALL_MASK, "C", nullptr);
  if (uselocale(nullptr) != plain) uselocale(plain);
}

}  // namespace tribunal
