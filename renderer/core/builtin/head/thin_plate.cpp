#include "core/builtin/head/thin_plate.h"

#include <Eigen/Dense>

namespace dermis::sculpt {
namespace {

constexpr double kPerMillimetre = 0.01;

double kernel(const glm::vec3& a, const glm::vec3& b) {
  const double r = static_cast<double>(glm::distance(a, b)) * kPerMillimetre;
  return r * r * r;
}

}  // namespace

ThinPlate::ThinPlate(const std::vector<Sample>& samples, double smoothing) {
  const auto n = static_cast<Eigen::Index>(samples.size());
  Eigen::MatrixXd matrix = Eigen::MatrixXd::Zero(n + 4, n + 4);
  Eigen::VectorXd right = Eigen::VectorXd::Zero(n + 4);
  for (Eigen::Index i = 0; i < n; ++i) {
    const Sample& sample = samples[static_cast<std::size_t>(i)];
    for (Eigen::Index j = 0; j < n; ++j)
      matrix(i, j) = kernel(sample.place, samples[static_cast<std::size_t>(j)].place);
    matrix(i, i) += smoothing;
    const Eigen::Vector4d linear(1.0, sample.place.x * kPerMillimetre, sample.place.y * kPerMillimetre,
                                 sample.place.z * kPerMillimetre);
    matrix.block<1, 4>(i, n) = linear.transpose();
    matrix.block<4, 1>(n, i) = linear;
    right(i) = sample.value;
    m_centres.push_back(sample.place);
  }
  const Eigen::VectorXd solved = matrix.partialPivLu().solve(right);
  m_weights.assign(solved.data(), solved.data() + n);
  for (Eigen::Index k = 0; k < 4; ++k) m_linear[k] = solved(n + k);
}

float ThinPlate::operator()(const glm::vec3& p) const {
  double sum = m_linear[0] + kPerMillimetre * (m_linear[1] * p.x + m_linear[2] * p.y + m_linear[3] * p.z);
  for (std::size_t i = 0; i < m_centres.size(); ++i) sum += m_weights[i] * kernel(p, m_centres[i]);
  return static_cast<float>(sum);
}

}  // namespace dermis::sculpt
