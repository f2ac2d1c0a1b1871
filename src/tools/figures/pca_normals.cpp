// SPDX-FileCopyrightText: 2026 scan_to_path developers
// SPDX-License-Identifier: Apache-2.0
#include "pca_normals.h"

#include <pcl/features/normal_3d.h>
#include <pcl/point_types.h>
#include <pcl/search/kdtree.h>

namespace scan_to_path::tools {

std::vector<geometry::Vector3> pcaNormals(const std::vector<geometry::Vector3>& points,
                                          const std::vector<std::size_t>& chosen, int neighbours,
                                          const geometry::Vector3& towards) {
  const pcl::PointCloud<pcl::PointXYZ>::Ptr cloud(new pcl::PointCloud<pcl::PointXYZ>);
  for (const auto& p : points) {
    cloud->push_back(pcl::PointXYZ(static_cast<float>(p.x()), static_cast<float>(p.y()), static_cast<float>(p.z())));
  }
  const pcl::IndicesPtr indices(new pcl::Indices(chosen.begin(), chosen.end()));
  const Eigen::Vector3f viewpoint = towards.cast<float>();
  pcl::NormalEstimation<pcl::PointXYZ, pcl::Normal> estimation;
  estimation.setInputCloud(cloud);
  estimation.setIndices(indices);
  estimation.setSearchMethod(pcl::search::KdTree<pcl::PointXYZ>::Ptr(new pcl::search::KdTree<pcl::PointXYZ>));
  estimation.setKSearch(neighbours);
  estimation.setViewPoint(viewpoint.x(), viewpoint.y(), viewpoint.z());
  pcl::PointCloud<pcl::Normal> found;
  estimation.compute(found);
  std::vector<geometry::Vector3> normals;
  for (const auto& normal : found) normals.push_back(normal.getNormalVector3fMap().cast<double>());
  return normals;
}

}  // namespace scan_to_path::tools
