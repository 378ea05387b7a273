#include "reports/study.hpp"

#include <numeric>

namespace crawford::reports {

Study& Study::refines(std::string axis, std::vector<int> values) {
    axis_ = std::move(axis);
    grids_ = std::move(values);
    return *this;
}

Study& Study::lists(std::string axis, int count) {
    axis_ = std::move(axis);
    grids_.resize(size_t(count));
    std::iota(grids_.begin(), grids_.end(), 1);
    is_a_list_ = true;
    return *this;
}

Study& Study::any_value() {
    takes_any_value_ = true;
    return *this;
}

Study& Study::at(const std::string& axis, AxisValue value) {
    fixed_.set(axis, std::move(value));
    return *this;
}

Setting Study::setting(int grid) const {
    Setting setting = fixed_;
    setting.set(axis_, long(grid));
    return setting;
}

Study& Study::measure(Measure measure) {
    run_ = [measure = std::move(measure)](Record& record) {
        record.found = measure(record.setting);
    };
    return *this;
}

Study& Study::measure(MeasureGrid measure) {
    run_ = [axis = axis_, measure = std::move(measure)](Record& record) {
        record.found = measure(record.setting.count(axis));
    };
    return *this;
}

Study& Study::run(FillRecord run) {
    run_ = std::move(run);
    return *this;
}

Study& Study::covers(std::vector<std::string> terms) {
    covered_ = std::move(terms);
    return *this;
}

Study& Study::gate(std::string quantity, Norm norm, Expectation expected, std::string reason) {
    rows_.emplace_back(ErrorGate{{std::move(quantity), norm, expected, std::move(reason)}});
    return *this;
}

Study& Study::difference_gate(std::string quantity, Norm norm, Expectation expected,
                              std::string reason) {
    rows_.emplace_back(DifferenceGate{{std::move(quantity), norm, expected, std::move(reason)}});
    return *this;
}

Study& Study::bound(std::string quantity, int grid, Interval allowed, std::string reason) {
    rows_.emplace_back(GridBound{{std::move(quantity), allowed, std::move(reason)}, grid});
    return *this;
}

Study& Study::limit_bound(std::string quantity, double formal_order, Interval allowed,
                          std::string reason) {
    rows_.emplace_back(LimitBound{{std::move(quantity), allowed, std::move(reason)}, formal_order});
    return *this;
}

Study& Study::total(std::string quantity, Interval allowed, std::string reason) {
    rows_.emplace_back(TotalBound{{std::move(quantity), allowed, std::move(reason)}});
    return *this;
}

}  // namespace crawford::reports
