package enlightenment.cli.store;

import enlightenment.cli.option.CommandFiles;
import enlightenment.store.RenderRow;
import enlightenment.store.SampleStore;
import enlightenment.store.StoreAddress;
import java.io.IOException;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Parameters;

/** The store that a command looks into, and which of its renders is meant. */
final class StoreArgument {
    @Parameters(
            index = "0",
            paramLabel = "STORE",
            description = "the store: a SQLite file, or the JDBC URL of a database")
    private String store;

    @Parameters(
            index = "1",
            arity = "0..1",
            paramLabel = "ID",
            description = "the render: the first digits of its id; not needed if there is only one")
    private String id;

    @Mixin
    private StoreAccess access = new StoreAccess();

    StoreArgument() {}

    private StoreAddress address() {
        return StoreAccess.address(store);
    }

    /** Adds the files that are read. */
    void register(CommandFiles files) throws IOException {
        StoreAccess.reads(address(), files);
        access.register(files);
    }

    SampleStore open() throws IOException {
        return SampleStore.open(address(), access.login());
    }

    SampleStore openToUnpack() throws IOException {
        return SampleStore.openToUnpack(address(), access.login());
    }

    boolean hasId() {
        return id != null;
    }

    /** The render that is meant. */
    RenderRow choose(SampleStore store) throws IOException {
        return store.choose(id == null ? "" : id);
    }
}
