package enlightenment.view;

import java.util.List;

/**
 * The status of a final render.
 *
 * @param version number of the status: each change of a component has a larger one
 * @param state whether the render runs, or how it ended
 * @param done the finished share of the picture, 0..1
 * @param seconds duration of the render so far, or as a whole
 * @param width width of the picture in pixels; 0 if there is no render
 * @param height height of the picture in pixels; 0 if there is no render
 * @param notes the last notes of the render, or the reasons of its failure, one in a line
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
