// tribunal sweep with the axis that aims rays at a mesh.
#include "tracer/cli/command.h"
#include "tracer/sweep/afar.h"

namespace tribunal {

Action declare_sweep(Arguments& arguments) {
  return declare_sweep(arguments, {afar_name, afar_quantity, afar_axis_of_file});
}

}  // namespace tribunal
