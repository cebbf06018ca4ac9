// Models that the program of the first visit does not know: kinds without coupling variances.

const OTHER_KIND = /"kind"\s*:\s*"(map-gpdm|map-cgpdm|tmp|dmp-discrete|dmp-rhythmic)"/;

export const hasNoCouplings = (document: string): boolean => OTHER_KIND.test(document);
