// Models that the program of the first visit does not know: kinds without coupling variances.

const OTHER_KIND = /"kind"\s*:\s*"(map-gpdm|map-cgpdm|tmp|dmp-discrete|dmp-rhythmic)"/;

/** The key of their motion on the stage; keys of clips begin with "made-" or "own-". */
export const OTHER_MODEL = "other-model";

export const hasNoCouplings = (document: string): boolean => OTHER_KIND.test(document);
