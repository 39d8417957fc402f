// Checks a certificate from scratch: no simulator takes part.

#include <istream>
#include <sstream>
#include <stdexcept>

#include "carom/certify/certify.hpp"
#include "carom/core/error.hpp"
#include "certificate.hpp"
#include "outcome.hpp"
#include "start.hpp"

namespace carom::certify {

namespace {

// The enclosures found here must lie within those of the file, so they have to be narrower.
constexpr int more_digits = 20;

std::string text_of(const System& system) {
  std::ostringstream text;
  write_system(text, system);
  return text.str();
}

Report check(std::istream& in, int digits, const Watch& watch) {
  CertificateReader reader(in);
  const Bits bits(bits_of_digits(digits));
  Replay replay(reader.system(), digits);
  Finding failure;
  bool interrupted = false;
  while (const std::optional<Claim> claim = reader.next()) {
    interrupted = watch.interrupt != nullptr && watch.interrupt->load();
    if (interrupted) break;
    failure = replay.take(*claim);
    if (failure.proof != Proof::yes) break;
    if (watch.progress) watch.progress(replay.events(), digits);
  }
  const Finding end = replay.finish(failure.proof == Proof::yes && !interrupted ? reader.until() : std::nullopt);
  if (failure.proof == Proof::yes) failure = end;
  Report report;
  report.events = end.proof == Proof::yes ? replay.events() : 0;
  judge(report, failure, interrupted);
  report.stopped_by = reader.until() ? "until" : "events";
  describe(report, replay, reader.system(), digits);
  return report;
}

}  // namespace

Report verify(std::istream& certificate, const Options& options, const Watch& watch, const Scene* scene) {
  try {
    const std::istream::pos_type begin = certificate.tellg();
    const auto rewound = [&]() -> std::istream& {
      certificate.clear();
      certificate.seekg(begin);
      return certificate;
    };
    int digits = 0;
    {
      const CertificateReader reader(certificate);
      digits = reader.digits();
      if (scene != nullptr && text_of(system_of(*scene)) != text_of(reader.system()))
        throw InputError(Problem{"", 0, "the certificate is of another scene", "", "Verify it alone, or with the scene that it was made of"});
      const std::string contact = contact_at_the_start(reader.system(), reader.system().balls.size());
      if (!contact.empty()) throw InputError(Problem{"", 0, contact, "a proof begins with all balls apart", "Give a certificate that carom wrote"});
    }
    const int first = std::max(options.digits, digits + more_digits);
    Options more = options;
    more.max_digits = std::max(options.max_digits, 2 * first);
    return with_more_digits(more, first, true, [&](int n) { return check(rewound(), n, watch); });
  } catch (const std::invalid_argument& error) {
    throw InputError(Problem{"", 0, error.what(), "", "Give a certificate that carom wrote"});
  }
}

}  // namespace carom::certify
