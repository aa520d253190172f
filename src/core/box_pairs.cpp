#include "core/box_pairs.hpp"

#include <algorithm>
#include <numeric>
#include <vector>

namespace sunder::core {
namespace {

constexpr int kFew = 4;  ///< boxes of a leaf

class Tree {
  public:
    Tree(std::span<const Box> boxes, const std::function<void(int, int)>& visit)
        : boxes_(boxes), visit_(visit), order_(boxes.size()) {
        std::iota(order_.begin(), order_.end(), 0);
        build(0, static_cast<int>(boxes.size()));
    }

    std::int64_t compare() {
        within(0);
        return compared_;
    }

  private:
    struct Node {
        Box around;
        int first, end;  ///< in order_
        int low = -1, high = -1;
        bool leaf() const { return low < 0; }
    };

    /// Halves the boxes where their centres lie farthest apart, so that the tree is as deep as
    /// log n, wherever they are.
    int build(int first, int end) {
        const int number = static_cast<int>(nodes_.size());
        Box around = boxes_[order_[first]];
        Box centres{around.centre(), around.centre()};
        for (int i = first; i < end; ++i) {
            const Box& box = boxes_[order_[i]];
            around.include(box);
            centres.include({box.centre(), box.centre()});
        }
        nodes_.push_back({around, first, end});
        if (end - first <= kFew) return number;
        int axis = 0;
        (centres.high - centres.low).maxCoeff(&axis);
        const int middle = first + (end - first) / 2;
        std::nth_element(order_.begin() + first, order_.begin() + middle, order_.begin() + end,
                         [&](int a, int b) {
                             return std::pair(boxes_[a].centre()[axis], a) <
                                    std::pair(boxes_[b].centre()[axis], b);
                         });
        const int low = build(first, middle), high = build(middle, end);
        nodes_[number].low = low;
        nodes_[number].high = high;
        return number;
    }

    bool overlap(const Box& a, const Box& b) {
        ++compared_;
        return a.overlaps(b);
    }

    void compareBoxes(int i, int j) {
        const auto [a, b] = std::minmax(order_[i], order_[j]);
        if (overlap(boxes_[a], boxes_[b])) visit_(a, b);
    }

    void within(int number) {
        const Node& node = nodes_[number];
        if (!node.leaf()) {
            within(node.low);
            within(node.high);
            between(node.low, node.high);
            return;
        }
        for (int i = node.first; i < node.end; ++i)
            for (int j = i + 1; j < node.end; ++j) compareBoxes(i, j);
    }

    void between(int a, int b) {
        const Node &first = nodes_[a], &second = nodes_[b];
        if (!overlap(first.around, second.around)) return;
        if (first.leaf() && second.leaf()) {
            for (int i = first.first; i < first.end; ++i)
                for (int j = second.first; j < second.end; ++j) compareBoxes(i, j);
        } else if (second.leaf() ||
                   (!first.leaf() && first.end - first.first > second.end - second.first)) {
            between(first.low, b);
            between(first.high, b);
        } else {
            between(a, second.low);
            between(a, second.high);
        }
    }

    std::span<const Box> boxes_;
    const std::function<void(int, int)>& visit_;
    std::vector<int> order_;
    std::vector<Node> nodes_;
    std::int64_t compared_ = 0;
};

}  // namespace

std::int64_t forEachOverlap(std::span<const Box> boxes,
                            const std::function<void(int, int)>& visit) {
    return boxes.empty() ? 0 : Tree(boxes, visit).compare();
}

}  // namespace sunder::core
