#include "build_impl.hpp"

namespace carom {

template World<double, 1> build<double, 1>(const Scene&);
template World<double, 2> build<double, 2>(const Scene&);
template World<double, 3> build<double, 3>(const Scene&);
template Time<double> clock_time<double>(const Number&, int);

}  // namespace carom
