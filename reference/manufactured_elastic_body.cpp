#include "reference/manufactured_elastic_body.hpp"

#include "reference/require.hpp"

namespace crawford::reference {

void WavyBody::require() const {
    require_positive("width", width);
    require_positive("depth", depth);
    require_finite("height", height);
    require_finite("phase", phase);
}

}  // namespace crawford::reference
