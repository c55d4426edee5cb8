/**
 * The protocol of server and workers: {@code Message}s as CBOR in checked frames, over a channel with deadlines.
 * docs/notes/distributed-protocol.md describes it.
 */
package enlightenment.net.protocol;
