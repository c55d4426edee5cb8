package enlightenment.net;

import enlightenment.engine.DividedRender;
import enlightenment.engine.FilmAssembly;
import enlightenment.listen.ServerLog;
import enlightenment.net.job.JobContent;
import enlightenment.net.server.ServerJob;

/**
 * A render of a picture that is served.
 *
 * @param render its units
 * @param film what is there of it
 * @param content what workers are sent
 */
record ServedPicture(DividedRender render, FilmAssembly film, JobContent content) {
    /** The render of which nothing is there yet. */
    static ServedPicture of(DividedRender render, JobContent content) {
        return new ServedPicture(render, render.assembly(), content);
    }

    /** The same picture with more samples. */
    ServedPicture with(DividedRender more) {
        return of(more, content.with(more.outline()));
    }

    ServerJob job(ServerLog log) {
        return ServerJob.of(render, film, content, log::say);
    }
}
