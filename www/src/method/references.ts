// The works behind the models, and those of the other equations of the view. CITATION.cff has some for programs;
// a test compares them.

/** The papers of the model, and the works that these build on, as lines of a list. */
export const WORKS: readonly { words: string; doi?: string }[] = [
  {
    words:
      "Velychko, D., Knopp, B., Endres, D. (2018). Making the Coupled Gaussian Process Dynamical Model Modular and Scalable with Variational Approximations. Entropy 20(10), 724.",
    doi: "10.3390/e20100724",
  },
  {
    words:
      "Velychko, D., Knopp, B., Endres, D. (2017). The Variational Coupled Gaussian Process Dynamical Model. ICANN 2017, 291–299.",
    // The DOI of the volume, which the paper itself names.
    doi: "10.1007/978-3-319-68600-4",
  },
  {
    words:
      "Knopp, B., Velychko, D., Dreibrodt, J., Endres, D. (2019). Predicting Perceived Naturalness of Human Animations Based on Generative Movement Primitive Models. ACM Transactions on Applied Perception 16(3), 15.",
    doi: "10.1145/3355401",
  },
  {
    words:
      "Velychko, D. (2020). Probabilistic Models of Motor Production. Doctoral thesis, Philipps University of Marburg.",
  },
  {
    words:
      "Velychko, D., Endres, D., Taubert, N., Giese, M. A. (2014). Coupling Gaussian Process Dynamical Models with Product-of-Experts Kernels. ICANN 2014, 603–610.",
  },
  {
    words:
      "Wang, J. M., Fleet, D. J., Hertzmann, A. (2008). Gaussian Process Dynamical Models for Human Motion. IEEE Transactions on Pattern Analysis and Machine Intelligence 30(2), 283–298.",
    doi: "10.1109/TPAMI.2007.1167",
  },
  {
    words:
      "Titsias, M. K., Lawrence, N. D. (2010). Bayesian Gaussian Process Latent Variable Model. AISTATS 2010, 844–851.",
  },
  {
    words:
      "Urtasun, R., Fleet, D. J., Fua, P. (2006). 3D People Tracking with Gaussian Process Dynamical Models. CVPR 2006, 238–245.",
  },
  { words: "Hinton, G. E. (1999). Products of Experts. ICANN 1999, 1–6." },
  {
    words:
      "Clever, D. et al. (2016). A Novel Approach for the Generation of Complex Humanoid Walking Sequences Based on a Combination of Optimal Control and Learning of Movement Primitives. Robotics and Autonomous Systems 83, 287–298.",
    doi: "10.1016/j.robot.2016.06.001",
  },
  {
    words:
      "Ijspeert, A. J. et al. (2013). Dynamical Movement Primitives: Learning Attractor Models for Motor Behaviors. Neural Computation 25(2), 328–373.",
    doi: "10.1162/NECO_a_00393",
  },
  {
    words:
      "Sakoe, H., Chiba, S. (1978). Dynamic Programming Algorithm Optimization for Spoken Word Recognition. IEEE Transactions on Acoustics, Speech and Signal Processing 26(1), 43–49.",
  },
];
