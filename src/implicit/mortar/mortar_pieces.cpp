// SPDX-License-Identifier: Apache-2.0
#include "mortar_pieces.hpp"

#include <algorithm>
#include <bit>
#include <compare>

#include "comm/rendezvous.hpp"

namespace brunt::implicit {
namespace {

/// Position of a piece in the order of the sums.
struct PieceKey {
  GlobalIndex interface = 0;
  /// 0: the patch of a facet; 1: weights of a row times derivatives of its traction; 2: the patch of a row's levers
  GlobalIndex of_tractions = 0;
  GlobalIndex source = 0;  ///< key of the facet, number of the row
  friend auto operator<=>(const PieceKey&, const PieceKey&) = default;
};

/// A piece computed on this rank; rows and columns are places in ContactNodes.
struct Piece {
  PieceKey key;
  std::span<const LocalIndex> rows, columns;
  const double* patch = nullptr;      ///< (3 rows) x (3 columns), or
  std::span<const double> weights{};  ///< block (r, c) is weights[r] slopes[c]
  std::span<const Mat3> slopes{};

  [[nodiscard]] Mat3 block(std::size_t r, std::size_t c) const {
    if (patch == nullptr) return weights[r] * slopes[c];
    const std::size_t width = 3 * columns.size();
    return Eigen::Map<const Eigen::Matrix<double, 3, 3, Eigen::RowMajor>, 0, Eigen::OuterStride<>>(
        patch + 3 * r * width + 3 * c, Eigen::OuterStride<>(static_cast<Eigen::Index>(width)));
  }
};

/// Calls visit(piece) for all pieces of this rank, in the order of their keys.
template <class Visit>
void for_each_piece(const MortarContact& contact, const std::vector<contact::TractionSlopes>& tractions,
                    const Visit& visit) {
  for (std::size_t k = 0; k < contact.interfaces.size(); ++k) {
    const Interface& face = contact.interfaces[k];
    const auto interface = static_cast<GlobalIndex>(k);
    for (std::size_t p = 0; p < face.iterate.slopes.weights.count; ++p) {
      const contact::Patch& patch = face.iterate.slopes.weights.patch[p];
      const auto source = static_cast<std::size_t>(face.iterate.slopes.weights.source[p]);
      const GlobalIndex key = face.of_points ? GlobalIndex{face.numbering.place[source]} : face.slave_key[source];
      visit(Piece{{interface, 0, key}, patch.rows, patch.columns, patch.values.data()});
    }
    const contact::NodeBlocks<Mat3>& slopes = tractions[k].by_position;
    for (LocalIndex row = 0; row < slopes.nodes.rows(); ++row) {
      visit(Piece{{interface, 1, nth(face.numbering.place, row)},
                  face.iterate.rows.weights.nodes.row(row),
                  slopes.nodes.row(row),
                  nullptr,
                  face.iterate.rows.weights.row(row),
                  slopes.row(row)});
    }
    for (std::size_t p = 0; face.consistent() && p < face.iterate.lever_patches.count; ++p) {
      const contact::Patch& patch = face.iterate.lever_patches.patch[p];
      const auto row = static_cast<std::size_t>(face.iterate.lever_patches.source[p]);
      visit(Piece{{interface, 2, face.numbering.place[row]}, patch.rows, patch.columns, patch.values.data()});
    }
  }
}

/// Pieces in a message, as words: key, numbers of rows and columns, their nodes, then values.
class Outgoing {
 public:
  Outgoing(Rank here, int ranks, const ContactNodes& nodes)
      : here_(here), nodes_(nodes), words_(static_cast<std::size_t>(ranks)), rows_(static_cast<std::size_t>(ranks)) {}

  /// Sends the rows of a piece that other ranks own to these.
  void send(const Piece& piece) {
    for (std::size_t r = 0; r < piece.rows.size(); ++r) {
      const Rank owner = nth(nodes_.source, piece.rows[r]).rank;
      if (owner == here_) continue;
      std::vector<std::size_t>& rows = nth(rows_, owner);
      if (rows.empty()) asked_.push_back(owner);
      rows.push_back(r);
    }
    for (const Rank owner : asked_) {
      write(piece, nth(rows_, owner), nth(words_, owner));
      nth(rows_, owner).clear();
    }
    asked_.clear();
  }
  [[nodiscard]] const std::vector<std::vector<GlobalIndex>>& words() const { return words_; }

 private:
  void write(const Piece& piece, const std::vector<std::size_t>& rows, std::vector<GlobalIndex>& words) const {
    const auto gid = [&](LocalIndex place) { return nth(nodes_.gid, place); };
    const auto put = [&](double value) { words.push_back(std::bit_cast<GlobalIndex>(value)); };
    const auto put_block = [&](const Mat3& block) { std::for_each_n(block.data(), 9, put); };
    words.insert(words.end(), {piece.key.interface, piece.key.of_tractions, piece.key.source,
                               static_cast<GlobalIndex>(rows.size()), static_cast<GlobalIndex>(piece.columns.size())});
    for (const std::size_t r : rows) words.push_back(gid(piece.rows[r]));
    for (const LocalIndex column : piece.columns) words.push_back(gid(column));
    if (piece.patch != nullptr) {
      for (const std::size_t r : rows)
        for (std::size_t c = 0; c < piece.columns.size(); ++c) put_block(piece.block(r, c));
    } else {
      for (const std::size_t r : rows) put(piece.weights[r]);
      for (const Mat3& slope : piece.slopes) put_block(slope);
    }
  }

  Rank here_;
  const ContactNodes& nodes_;
  std::vector<std::vector<GlobalIndex>> words_;
  std::vector<std::vector<std::size_t>> rows_;  ///< of the current piece, by rank
  std::vector<Rank> asked_;                     ///< ranks that have some of these
};

/// Pieces of other ranks, by their keys.
class Incoming {
 public:
  explicit Incoming(std::vector<GlobalIndex> words) : words_(std::move(words)) {
    for (std::size_t at = 0; at < words_.size(); at += length(at))
      pieces_.push_back({{words_[at], words_[at + 1], words_[at + 2]}, at});
    std::ranges::sort(pieces_, {}, &Place::key);
  }
  /// Adds the pieces before a key.
  void add_before(const PieceKey& key, const ContactNodes& nodes, const TakeBlock& take) {
    for (; next_ < pieces_.size() && pieces_[next_].key < key; ++next_) add(pieces_[next_].at, nodes, take);
  }
  void add_rest(const ContactNodes& nodes, const TakeBlock& take) {
    for (; next_ < pieces_.size(); ++next_) add(pieces_[next_].at, nodes, take);
  }

 private:
  struct Place {
    PieceKey key;
    std::size_t at = 0;
  };
  static constexpr std::size_t header = 5;

  [[nodiscard]] std::size_t rows(std::size_t at) const { return static_cast<std::size_t>(words_[at + 3]); }
  [[nodiscard]] std::size_t columns(std::size_t at) const { return static_cast<std::size_t>(words_[at + 4]); }
  [[nodiscard]] std::size_t length(std::size_t at) const {
    const std::size_t r = rows(at), c = columns(at);
    return header + r + c + (words_[at + 1] == 1 ? r + 9 * c : 9 * r * c);
  }
  [[nodiscard]] Mat3 block(std::size_t at) const {
    Mat3 block;
    for (std::size_t k = 0; k < 9; ++k) block.data()[k] = std::bit_cast<double>(words_[at + k]);
    return block;
  }
  void add(std::size_t at, const ContactNodes& nodes, const TakeBlock& take) const {
    const std::size_t r = rows(at), c = columns(at), first = at + header, values = first + r + c;
    for (std::size_t i = 0; i < r; ++i) {
      const LocalIndex row = nodes.place_of(words_[first + i]);
      for (std::size_t j = 0; j < c; ++j) {
        const GlobalIndex column = words_[first + r + j];
        if (words_[at + 1] == 1)
          take(row, column, std::bit_cast<double>(words_[values + i]) * block(values + r + 9 * j));
        else
          take(row, column, block(values + 9 * (i * c + j)));
      }
    }
  }

  std::vector<GlobalIndex> words_;
  std::vector<Place> pieces_;
  std::size_t next_ = 0;
};

}  // namespace

void sum_pieces(const comm::Communicator& ranks, const MortarContact& contact,
                const std::vector<contact::TractionSlopes>& tractions, const TakeBlock& take) {
  const ContactNodes& nodes = contact.nodes;
  Outgoing outgoing(ranks.rank(), ranks.size(), nodes);
  for_each_piece(contact, tractions, [&](const Piece& piece) { outgoing.send(piece); });
  Incoming incoming(comm::exchange(ranks, outgoing.words()).values);
  for_each_piece(contact, tractions, [&](const Piece& piece) {
    incoming.add_before(piece.key, nodes, take);
    for (std::size_t r = 0; r < piece.rows.size(); ++r) {
      if (nth(nodes.source, piece.rows[r]).rank != ranks.rank()) continue;
      for (std::size_t c = 0; c < piece.columns.size(); ++c)
        take(piece.rows[r], nth(nodes.gid, piece.columns[c]), piece.block(r, c));
    }
  });
  incoming.add_rest(nodes, take);
}

}  // namespace brunt::implicit
