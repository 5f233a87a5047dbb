#pragma once

#include <string>

#include "structure_from_wifi/input_error.h"

namespace sfw::test {

/// The text of the InputError that an action throws; "nothing" if it throws none.
template <class Action>
std::string complaintOf(Action&& action) {
  try {
    action();
  } catch (const InputError& error) {
    return error.what();
  }
  return "nothing";
}

}  // namespace sfw::test
