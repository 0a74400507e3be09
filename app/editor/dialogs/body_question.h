#pragma once

#include "core/model/detail.h"
#include "widgets/inputs/number_field.h"

#include <QButtonGroup>
#include <QComboBox>
#include <QFormLayout>
#include <QLabel>
#include <QWidget>

#include <array>
#include <optional>
#include <utility>

namespace esm {

/// What becomes of a surface. Of a solid body `detail.nodes` are those wanted; a lattice has them about. Of a
/// wall of prisms there is a filling.
struct BodyChoice {
    Detail detail;
    bool resistsBending = false; ///< of a hollow organ's wall
};

/// Asks whether an organ is hollow or solid and how much of it moves, and says what each costs.
class BodyQuestion : public QWidget {
    Q_OBJECT

public:
    explicit BodyQuestion(QWidget* parent = nullptr);

    /// Of which surface it is asked.
    /// @param meanEdge of its triangles, m
    void setSurface(std::size_t vertices, bool isClosed, double meanEdge);
    BodyChoice choice() const;
    /// Why no such organ can be made of the surface; empty where one can.
    QString refusal() const;

signals:
    void changed();

private:
    enum Body { Hollow, Walled, Prisms, Solid };

    void addBodies(QFormLayout* form);
    void addDetail(QFormLayout* form);
    Body body() const { return static_cast<Body>(m_bodies->checkedId()); }
    Detail::Kind kind() const;
    LatticeFilling wall() const;
    double wallNodes() const;
    void showChoice();
    void showNodes();
    void showWork();
    QString suggestion() const;
    double hollowNodes() const;

    QButtonGroup* m_bodies;
    std::array<QLabel*, 4> m_work;
    QComboBox* m_detail;
    NumberField *m_nodes, *m_thickness;
    QLabel* m_suggestion;
    std::size_t m_vertices = 0;
    bool m_isClosed = true;
    double m_meanEdge = 0;                                     ///< m
    double m_fewerNodes, m_solidNodes;                         ///< as last asked for
    std::optional<std::pair<Body, Detail::Kind>> m_shownNodes; ///< for what
};

} // namespace esm
