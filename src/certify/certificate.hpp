#pragma once
// The certificate: a system, and its proven events with the enclosures of their times.
//
// A table with # comments. The head is the system in exact numbers; a row is an event; the last line says up to where
// nothing else happens.

#include <iosfwd>
#include <optional>
#include <string>

#include "carom/certify/claim.hpp"
#include "carom/certify/system.hpp"

namespace carom::certify {

void write_head(std::ostream& out, const System& system, int digits);
void write_event(std::ostream& out, const System& system, std::int64_t number, const Claim& claim);
/// `until` [time]; none: up to the last event.
void write_end(std::ostream& out, const std::optional<Rational>& until);

class CertificateReader {
 public:
  /// Reads the head. Throws std::invalid_argument, as `next` does.
  explicit CertificateReader(std::istream& in);

  [[nodiscard]] const System& system() const { return system_; }
  [[nodiscard]] int digits() const { return digits_; }
  /// The next event; none at the end.
  [[nodiscard]] std::optional<Claim> next();
  /// Up to when nothing else happens, once `next` has come to the end.
  [[nodiscard]] const std::optional<Rational>& until() const { return until_; }

 private:
  std::istream& in_;
  System system_;
  int digits_ = 0;
  std::int64_t row_ = 0;
  std::optional<Rational> until_;
};

}  // namespace carom::certify
