package enlightenment.net.job;

import enlightenment.engine.FilmRoom;
import enlightenment.render.RenderRequest;
import java.util.Optional;

/** Places for the pixels of pictures that are assembled from other machines' results. */
public final class PictureRoom {
    private PictureRoom() {}

    /** In memory, or in a file of this folder; in memory only without one. */
    public static FilmRoom of(Optional<RenderRequest.ScratchFolder> scratch) {
        return scratch.map(s -> new FilmRoom(Optional.of(s.folder()), s.memory()))
                .orElse(FilmRoom.MEMORY);
    }
}
