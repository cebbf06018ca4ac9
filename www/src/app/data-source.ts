// Whom the recordings are owed to, in the words that they ask for.
export const DATA_SOURCE =
  "The data used in this project was obtained from mocap.cs.cmu.edu. The database was created with funding from NSF EIA-0196217.";
