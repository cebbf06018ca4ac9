// The source of the recordings, in the words that it asks for.
export const DATA_SOURCE =
  "The data used in this project was obtained from mocap.cs.cmu.edu. The database was created with funding from NSF EIA-0196217.";
/** The address where the recordings are had. */
export const RECORDINGS = "http://mocap.cs.cmu.edu";
