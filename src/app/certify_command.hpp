#pragma once
// carom certify: a proof of the event order.

#include <string>

#include <CLI/App.hpp>

#include "console.hpp"
#include "exit_status.hpp"
#include "scene_arguments.hpp"

namespace carom::app {

struct CertifyOptions {
  SceneArguments scene;
  int digits = 50;          ///< of the first try
  int max_digits = 12'800;  ///< of the last
  std::string out;          ///< folder for certified.csv; empty: the current one
  std::string verify;       ///< a certificate to be checked
  bool json = false;
};

CLI::App* add_certify_command(CLI::App& program, CertifyOptions& options);

/// Proves the log of a scene and writes the certificate, or checks one. `stopped` if not all is proven. Throws InputError,
/// OutputError.
ExitStatus certify(const CertifyOptions& options, const Console& console);

}  // namespace carom::app
