package enlightenment.render;

import enlightenment.engine.PictureFilm;
import enlightenment.image.Image;
import enlightenment.report.RenderReport;
import enlightenment.work.Phases;
import java.util.List;

/** One render of a planned picture in this process. */
interface PictureRender {
    /** Does the units, unless it is cancelled. */
    void run();

    /** The film with the rendered pixels, in full precision. */
    PictureFilm film();

    /** The picture as it stands: the film, and what a preview that is kept shows where that is not finished. */
    Image image();

    /** The number of pixels that have samples, their own or a preview's. */
    long shownPixels();

    /**
     * The report of the render; to be called after the last picture.
     *
     * @param rounding the error of rounding the picture to the depth of its file
     * @param round how often the picture was rendered
     */
    RenderReport report(Phases phases, double rounding, int round);

    /** The ray clusters that were asked for, in an order that does not depend on threads. */
    default List<RenderResult.RayCluster> clusters() {
        return List.of();
    }

    /** The chains that were asked for, in an order that does not depend on threads: those of a group as they were followed. */
    default List<RenderResult.PathChain> chains() {
        return List.of();
    }
}
