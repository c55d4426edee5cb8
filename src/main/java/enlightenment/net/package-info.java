/**
 * Many machines, one picture: a server that hands out tile columns and workers that render them.
 *
 * <p>{@link enlightenment.net.RenderServer} and {@link enlightenment.net.RenderWorker} are the two sides; {@link
 * enlightenment.net.parts.RenderParts} does the same by files, for job arrays; {@link enlightenment.net.EngineJob} is for engines
 * that move data and tiles themselves, such as Spark.
 *
 * <p>The packages below are internal: {@code schedule} decides who renders what, {@code protocol} and {@code secure} what is
 * said and who may say it, {@code checkpoint} and {@code job} what survives and what travels, {@code server}, {@code worker},
 * {@code listen} and {@code status} are the two sides with their threads and sockets. docs/notes/distributed-protocol.md describes
 * the protocol.
 */
package enlightenment.net;
