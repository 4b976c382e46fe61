//! Tanner, Jadbabaie and Pappas: agents with accelerations, heading and velocity alignment, fixed and switching networks.
