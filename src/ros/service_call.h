/// Calls of services whose answers arrive.
#pragma once

#include <ros/node_handle.h>

#include <string>

namespace sfw {

/// Calls a service over a connection that the client closes. Returns whether it answered.
///
/// callService() uses a connection that the server closes after its answer. Under load
/// roscpp 1.15.15 sees that end before it reads the answer and returns false, though the service
/// was carried out (findings/roscpp_loses_service_answers.sh).
template <class Service>
bool callService(const std::string& name, Service& service) {
  constexpr bool kPersistent = true;
  return ros::NodeHandle().serviceClient<Service>(name, kPersistent).call(service);
}

}  // namespace sfw
