#include "carom/core/multi.hpp"

#include "build_impl.hpp"

namespace carom {

template World<long double, 1> build<long double, 1>(const Scene&);
template World<long double, 2> build<long double, 2>(const Scene&);
template World<long double, 3> build<long double, 3>(const Scene&);
template Time<long double> clock_time<long double>(const Number&, int);

template World<Multi, 1> build<Multi, 1>(const Scene&);
template World<Multi, 2> build<Multi, 2>(const Scene&);
template World<Multi, 3> build<Multi, 3>(const Scene&);
template Time<Multi> clock_time<Multi>(const Number&, int);

}  // namespace carom
