package enlightenment.net;

import enlightenment.engine.DividedRender;
import enlightenment.engine.FilmAssembly;
import enlightenment.engine.Preview;
import enlightenment.listen.ServerLog;
import enlightenment.net.job.JobContent;
import enlightenment.net.server.ServerJob;

/**
 * A render of a picture that is served.
 *
 * @param render its units
 * @param film what is there of it
 * @param content what workers are sent
 * @param preview what is shown where nothing is finished yet; null for nothing
 */
record ServedPicture(DividedRender render, FilmAssembly film, JobContent content, Preview preview) {
    /** The render of which nothing is there yet. */
    static ServedPicture of(DividedRender render, JobContent content, Preview preview) {
        FilmAssembly film = render.assembly();
        film.showBeneath(preview);
        return new ServedPicture(render, film, content, preview);
    }

    /** This picture, content and preview with a render of more samples, of which no unit is done yet. */
    ServedPicture with(DividedRender more) {
        return of(more, content.with(more.outline()), preview);
    }

    ServerJob job(ServerLog log) {
        return ServerJob.of(render, film, content, log::say);
    }
}
