"""Arms out of URDF files, the robot descriptions of ROS, and into them."""
