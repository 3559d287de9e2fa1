#include "tests/support/data_folder.hpp"

namespace tripus::testing {

std::string data_folder() { return TRIPUS_DATA_DIR; }

}  // namespace tripus::testing
