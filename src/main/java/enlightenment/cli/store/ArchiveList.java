package enlightenment.cli.store;

import enlightenment.cli.terminal.Terminal;
import enlightenment.file.FileFailure;
import enlightenment.render.RenderResult;
import java.io.Closeable;
import java.io.IOException;
import java.util.ArrayList;
import java.util.List;

/** The archives of a render, which are closed together; one that cannot be does not cost the picture. */
public final class ArchiveList implements Closeable {
    private final List<RenderResult.Archive> all = new ArrayList<>();
    private final Terminal terminal;

    public ArchiveList(Terminal terminal) {
        this.terminal = terminal;
    }

    public void add(RenderResult.Archive archive) {
        all.add(archive);
    }

    public List<RenderResult.Archive> all() {
        return List.copyOf(all);
    }

    @Override
    public void close() {
        for (RenderResult.Archive archive : all) {
            try {
                archive.close();
            } catch (IOException e) {
                terminal.say(archive.name() + ": " + FileFailure.described(e));
            } catch (RuntimeException e) {
                // The picture is not written yet.
                terminal.say(archive.name() + ": " + e);
            }
        }
    }
}
