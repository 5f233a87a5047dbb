#include "files/mrpt_library.h"

#include <dlfcn.h>

#include <stdexcept>

namespace sfw {
namespace {

const MrptFunctions& load() {
  constexpr const char* kLibrary = "libstructure_from_wifi_mrpt.so";
  void* const library = dlopen(kLibrary, RTLD_NOW | RTLD_LOCAL);  // stays until the process ends
  const void* const functions = library == nullptr ? nullptr : dlsym(library, "sfw_mrpt_functions");
  if (functions == nullptr) {
    throw std::runtime_error(std::string(kLibrary) + " cannot be loaded (" + dlerror() +
                             "); install the package again, or add its folder of libraries to "
                             "LD_LIBRARY_PATH");
  }
  return *static_cast<const MrptFunctions*>(functions);
}

}  // namespace

const MrptFunctions& mrptFunctions() {
  static const MrptFunctions& functions = load();
  return functions;
}

}  // namespace sfw
