/**
 * The paper's ray clusters ({@link enlightenment.method.cluster.ClusterMethod}): a survey of evenly spaced rays is a control
 * variate for the colour of each pixel and evidence of where samples are needed; the samples are allocated accordingly; and rays
 * that end on the same surface and light propose light points to each other. docs/cluster-sampler.md has the derivation and the
 * measurements. Internal.
 */
package enlightenment.method.cluster;
