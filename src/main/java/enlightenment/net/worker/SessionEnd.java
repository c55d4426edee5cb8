package enlightenment.net.worker;

/**
 * How a session ended.
 *
 * @param isFinal whether trying again makes no sense
 * @param isDone whether the server said that the picture is done
 * @param reason in words
 */
public record SessionEnd(boolean isFinal, boolean isDone, String reason) {}
