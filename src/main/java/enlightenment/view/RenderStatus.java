package enlightenment.view;

import java.util.List;

/**
 * How a final render gets on.
 *
 * @param version counts changes of any of this
 * @param state what becomes of it
 * @param done the finished share of the picture, 0..1
 * @param seconds since it began, or that it took
 * @param width of the picture in pixels; 0 if there is no render
 * @param height of the picture in pixels; 0 if there is no render
 * @param notes what is to be known about it, or why it failed, one in a line
 */
record RenderStatus(long version, State state, double done, double seconds, int width, int height, List<String> notes) {
    enum State {
        NONE,
        RUNNING,
        DONE,
        CANCELLED,
        FAILED
    }

    boolean isRunning() {
        return state == State.RUNNING;
    }
}
