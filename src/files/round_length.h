#pragma once

namespace sfw {

/// The longest of 1, 2, 5, 10, 20, ... 500 m that is at most `most_m`; 1 m if none is. For the
/// scale bars and axes of pictures.
inline double roundLength(double most_m) {
  double metres = 1.0;
  for (const double longer : {2.0, 5.0, 10.0, 20.0, 50.0, 100.0, 200.0, 500.0}) {
    metres = longer <= most_m ? longer : metres;
  }
  return metres;
}

}  // namespace sfw
