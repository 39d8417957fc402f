// In the place of the proofs, where carom was built without MPFI.

#include "carom/certify/certify.hpp"
#include "carom/core/error.hpp"

namespace carom::certify {

namespace {

[[noreturn]] void refuse() {
  throw InputError(Problem{"", 0, "this carom makes no proofs", "it was built without MPFI", "Build it where libmpfi-dev is installed"});
}

}  // namespace

Report prove(const Scene&, const Options&, const Watch&) { refuse(); }
Report verify(std::istream&, const Options&, const Watch&, const Scene*) { refuse(); }

}  // namespace carom::certify
