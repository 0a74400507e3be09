#include "core/dynamics/elimination/block_factor.h"

#include "core/dynamics/elimination/panel_kernel.h"

#include <Eigen/Cholesky>

#include <algorithm>
#include <array>
#include <utility>

namespace esm {

namespace {

using Eigen::MatrixXd;
using Eigen::Vector3d;

/// What blocks take from the rows below them, until the next block of these rows takes it over.
class Elimination {
public:
    Elimination(const FactorPlan& plan, double* values)
        : m_plan(plan), m_values(values), m_updates(plan.blocks.size()) {}

    bool eliminate(std::size_t number);

private:
    void takeOver(const BlockLinks& child, MatrixXd& update, Eigen::Map<MatrixXd>& panel,
                  MatrixXd& own) const;

    const FactorPlan& m_plan;
    double* m_values;
    std::vector<MatrixXd> m_updates; ///< by block, between its rows below: lower halves
};

/// Adds a child's update to the panel and to the block's own update, and forgets it.
void Elimination::takeOver(const BlockLinks& child, MatrixXd& update, Eigen::Map<MatrixXd>& panel,
                           MatrixXd& own) const {
    const auto width = panel.cols();
    for (Eigen::Index j = 0; j < update.cols(); ++j) {
        const Eigen::Index column = child.placesInParent[static_cast<std::size_t>(j)];
        double* const into = column < width ? &panel(0, column) : &own(0, column - width) - width;
        for (Eigen::Index i = j; i < update.rows(); ++i)
            into[child.placesInParent[static_cast<std::size_t>(i)]] += update(i, j);
    }
    update.resize(0, 0);
}

bool Elimination::eliminate(std::size_t number) {
    const FactorBlock& block = m_plan.blocks[number];
    const auto width = static_cast<Eigen::Index>(block.width());
    const auto rest = static_cast<Eigen::Index>(block.belowCount);
    Eigen::Map<MatrixXd> panel(m_values + block.values, width + rest, width);
    MatrixXd& update = m_updates[number];
    update.setZero(rest, rest);
    for (const int child : m_plan.links[number].children)
        takeOver(m_plan.links[static_cast<std::size_t>(child)], m_updates[static_cast<std::size_t>(child)],
                 panel, update);
    Eigen::Ref<MatrixXd> triangle = panel.topRows(width);
    if (const Eigen::LLT<Eigen::Ref<MatrixXd>> inPlace(triangle); inPlace.info() != Eigen::Success)
        return false;
    auto below = panel.bottomRows(rest);
    triangle.triangularView<Eigen::Lower>().transpose().solveInPlace<Eigen::OnTheRight>(below);
    update.selfadjointView<Eigen::Lower>().rankUpdate(below, -1.0);
    return true;
}

const kernel::PanelFunctions& panelFunctions() {
    static const kernel::PanelFunctions& functions =
        __builtin_cpu_supports("avx2") ? kernel::v3::panelFunctions : kernel::v2::panelFunctions;
    return functions;
}

/// The rows of one block at a time out of vectors in the factor's order, x, y and z apart.
class BlockSides {
public:
    explicit BlockSides(const FactorPlan& plan)
        : m_plan(plan), m_values(3 * plan.mostRows), m_stride(plan.mostRows) {}

    kernel::PanelSides sides() { return {{at(0, 0), at(1, 0), at(2, 0)}}; }

    void take(const FactorBlock& block, const std::vector<Vector3d>& vectors) {
        forEachRow(block, [&](std::size_t place, std::size_t row) {
            for (std::size_t axis = 0; axis < 3; ++axis)
                *at(axis, place) = vectors[row][static_cast<Eigen::Index>(axis)];
        });
    }
    /// @param count of the block's rows, from the first one on
    void give(const FactorBlock& block, std::size_t count, std::vector<Vector3d>& vectors) {
        forEachRow(block, [&](std::size_t place, std::size_t row) {
            for (std::size_t axis = 0; place < count && axis < 3; ++axis)
                vectors[row][static_cast<Eigen::Index>(axis)] = *at(axis, place);
        });
    }

private:
    double* at(std::size_t axis, std::size_t place) { return m_values.data() + axis * m_stride + place; }

    template<class Visit> void forEachRow(const FactorBlock& block, const Visit& visit) const {
        for (std::size_t place = 0; place < block.width(); ++place)
            visit(place, static_cast<std::size_t>(block.begin) + place);
        std::size_t place = block.width();
        for (const int row : m_plan.below(block))
            visit(place++, static_cast<std::size_t>(row));
    }

    const FactorPlan& m_plan;
    std::vector<double> m_values;
    std::size_t m_stride;
};

kernel::Panel panelOf(const FactorBlock& block, const LargeVector<double>& values) {
    return {values.data() + block.values, block.width(), block.height()};
}

/// Columns up to which it takes longer to lay a block's rows side by side than to go through them where they
/// are, by measurement on nets: of these most blocks are as narrow.
constexpr std::size_t narrow = 8;

/// As the kernel's functions, on vectors in the factor's order.
template<std::size_t width>
void solveLowerInPlace(const FactorPlan& plan, const FactorBlock& block, const double* panel,
                       std::vector<Vector3d>& vectors) {
    const std::size_t height = block.height();
    const std::span<const int> below = plan.below(block);
    std::array<Vector3d, width> solved;
    for (std::size_t column = 0; column < width; ++column) {
        Vector3d& own = vectors[static_cast<std::size_t>(block.begin) + column];
        for (std::size_t k = 0; k < column; ++k)
            own -= panel[k * height + column] * solved[k];
        solved[column] = own /= panel[column * height + column];
    }
    for (std::size_t i = 0; i < below.size(); ++i) {
        Vector3d vector = vectors[static_cast<std::size_t>(below[i])];
        for (std::size_t k = 0; k < width; ++k)
            vector -= panel[k * height + width + i] * solved[k];
        vectors[static_cast<std::size_t>(below[i])] = vector;
    }
}

template<std::size_t width>
void solveUpperInPlace(const FactorPlan& plan, const FactorBlock& block, const double* panel,
                       std::vector<Vector3d>& vectors) {
    const std::size_t height = block.height();
    const std::span<const int> below = plan.below(block);
    std::array<Vector3d, width> sums;
    std::copy_n(vectors.begin() + block.begin, width, sums.begin());
    for (std::size_t i = 0; i < below.size(); ++i) {
        const Vector3d vector = vectors[static_cast<std::size_t>(below[i])];
        for (std::size_t k = 0; k < width; ++k)
            sums[k] -= panel[k * height + width + i] * vector;
    }
    for (std::size_t column = width; column-- > 0;) {
        for (std::size_t k = column + 1; k < width; ++k)
            sums[column] -= panel[column * height + k] * sums[k];
        sums[column] /= panel[column * height + column];
    }
    std::copy_n(sums.begin(), width, vectors.begin() + block.begin);
}

using InPlace = void (*)(const FactorPlan& plan, const FactorBlock& block, const double* panel,
                         std::vector<Vector3d>& vectors);

/// By width, from 1 on.
template<std::size_t... w> constexpr std::array<InPlace, narrow> lowerInPlace(std::index_sequence<w...>) {
    return {solveLowerInPlace<w + 1>...};
}
template<std::size_t... w> constexpr std::array<InPlace, narrow> upperInPlace(std::index_sequence<w...>) {
    return {solveUpperInPlace<w + 1>...};
}
constexpr auto narrowLower = lowerInPlace(std::make_index_sequence<narrow>());
constexpr auto narrowUpper = upperInPlace(std::make_index_sequence<narrow>());

} // namespace

// The multifrontal method (Duff and Reid 1983): each block's panel is factorised as a dense matrix, and what
// it takes from the rows below it is a dense matrix as well, which the next block of these rows takes over.
// Nearly all work is then products of dense matrices, which keep a processor busy: some ten times as fast as
// column by column.
std::optional<BlockFactor> BlockFactor::of(const Eigen::SparseMatrix<double>& lower,
                                           std::shared_ptr<const FactorPlan> plan) {
    BlockFactor factor(std::move(plan));
    const std::vector<std::size_t>& targets = factor.m_plan->targets;
    for (std::size_t entry = 0; entry < targets.size(); ++entry)
        factor.m_values[targets[entry]] = lower.valuePtr()[entry];
    Elimination elimination(*factor.m_plan, factor.m_values.data());
    for (std::size_t number = 0; number < factor.m_plan->blocks.size(); ++number)
        if (!elimination.eliminate(number)) return std::nullopt;
    return factor;
}

void BlockFactor::solveLower(std::vector<Vector3d>& vectors) const {
    BlockSides rows(*m_plan);
    for (const FactorBlock& block : m_plan->blocks) {
        if (block.width() <= narrow) {
            narrowLower[block.width() - 1](*m_plan, block, m_values.data() + block.values, vectors);
            continue;
        }
        rows.take(block, vectors);
        panelFunctions().solveLower(panelOf(block, m_values), rows.sides());
        rows.give(block, block.height(), vectors);
    }
}

void BlockFactor::solveUpper(std::vector<Vector3d>& vectors) const {
    BlockSides rows(*m_plan);
    for (auto block = m_plan->blocks.rbegin(); block != m_plan->blocks.rend(); ++block) {
        if (block->width() <= narrow) {
            narrowUpper[block->width() - 1](*m_plan, *block, m_values.data() + block->values, vectors);
            continue;
        }
        rows.take(*block, vectors);
        panelFunctions().solveUpper(panelOf(*block, m_values), rows.sides());
        rows.give(*block, block->width(), vectors);
    }
}

std::vector<Vector3d> BlockFactor::multiplyUpper(const std::vector<Vector3d>& vectors) const {
    std::vector<Vector3d> products(vectors.size(), Vector3d::Zero());
    for (const FactorBlock& block : m_plan->blocks) {
        const std::span<const int> below = m_plan->below(block);
        const double* column = m_values.data() + block.values;
        for (std::size_t c = 0; c < block.width(); ++c, column += block.height()) {
            Vector3d& product = products[static_cast<std::size_t>(block.begin) + c];
            for (std::size_t r = c; r < block.width(); ++r)
                product += column[r] * vectors[static_cast<std::size_t>(block.begin) + r];
            for (std::size_t i = 0; i < below.size(); ++i)
                product += column[block.width() + i] * vectors[static_cast<std::size_t>(below[i])];
        }
    }
    return products;
}

/// Numbers of the blocks on the way from a row to the root of the elimination tree: the row's own, and always
/// on to that of the first row below.
std::vector<int> BlockFactor::wayFrom(int row) const {
    const std::vector<FactorBlock>& blocks = m_plan->blocks;
    std::vector<int> way;
    for (int next = row; next >= 0;) {
        const auto block = std::upper_bound(blocks.begin(), blocks.end(), next,
                                            [](int r, const FactorBlock& b) { return r < b.end; });
        way.push_back(static_cast<int>(block - blocks.begin()));
        next = block->belowCount == 0 ? -1 : m_plan->rowsBelow[block->firstBelow];
    }
    return way;
}

/// Of up to three rows at once, as the three right-hand sides of one solution.
/// @param zeros as many as there are rows; so again afterwards
void BlockFactor::solveUnits(std::span<const int> rows, std::vector<Vector3d>& zeros,
                             std::vector<HalfColumn>& columns) const {
    std::vector<int> all;
    for (std::size_t i = 0; i < rows.size(); ++i) {
        zeros[static_cast<std::size_t>(rows[i])][static_cast<Eigen::Index>(i)] = 1;
        const std::vector<int> way = wayFrom(rows[i]);
        all.insert(all.end(), way.begin(), way.end());
    }
    std::sort(all.begin(), all.end());
    all.erase(std::unique(all.begin(), all.end()), all.end());
    BlockSides sides(*m_plan);
    for (const int number : all) {
        const FactorBlock& block = m_plan->blocks[static_cast<std::size_t>(number)];
        sides.take(block, zeros);
        panelFunctions().solveLower(panelOf(block, m_values), sides.sides());
        sides.give(block, block.height(), zeros);
    }
    for (std::size_t i = 0; i < rows.size(); ++i) {
        HalfColumn& column = columns.emplace_back();
        int row = rows[i];
        for (const int number : wayFrom(row)) {
            const FactorBlock& block = m_plan->blocks[static_cast<std::size_t>(number)];
            for (; row < block.end; ++row) {
                column.rows.push_back(row);
                column.values.push_back(zeros[static_cast<std::size_t>(row)][static_cast<Eigen::Index>(i)]);
            }
            if (block.belowCount > 0) row = m_plan->rowsBelow[block.firstBelow];
        }
    }
    for (const int number : all) {
        const FactorBlock& block = m_plan->blocks[static_cast<std::size_t>(number)];
        std::fill(zeros.begin() + block.begin, zeros.begin() + block.end, Vector3d::Zero());
    }
}

// Solves L·x = e for each row's unit vector. Only the rows on the way from that row to the root of the
// elimination tree come out other than zero (Davis 2006), so that only the blocks of the way are gone
// through. All rows below a block lie on its way.
std::vector<HalfColumn> BlockFactor::halfColumns(const std::vector<int>& rows) const {
    std::vector<HalfColumn> columns;
    std::vector<Vector3d> zeros(rowCount(), Vector3d::Zero());
    for (std::size_t first = 0; first < rows.size(); first += 3)
        solveUnits(std::span(rows).subspan(first, std::min<std::size_t>(3, rows.size() - first)), zeros,
                   columns);
    return columns;
}

} // namespace esm
