package enlightenment.cli.measure;

import enlightenment.cli.option.FileNames;
import enlightenment.cli.terminal.Launcher;
import enlightenment.cli.terminal.Shell;
import enlightenment.cli.terminal.Terminal;
import enlightenment.file.WholeFile;
import enlightenment.image.ImageFiles;
import enlightenment.measure.Trade;
import enlightenment.measure.analysis.CostEstimate;
import enlightenment.measure.analysis.EqualTimeComparison;
import enlightenment.measure.analysis.MethodChoice;
import enlightenment.measure.analysis.TradeAnalysis;
import enlightenment.measure.analysis.Verdict;
import enlightenment.measure.chart.Chart;
import enlightenment.measure.chart.TradeCharts;
import enlightenment.measure.page.PageContext;
import enlightenment.measure.page.TradePage;
import enlightenment.measure.trade.TradeResult;
import enlightenment.measure.trade.TradeSettings;
import java.io.IOException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;

/** Writes what a trade found: figures, charts, the page, and the advice on standard output. */
final class TradeOutput {
    private static final String FIGURES = "trade.json";
    private static final String PAGE = "index.html";
    private static final String SUMMARY = "summary.csv";

    private final Terminal terminal;
    private final Path folder;
    private final Path sceneFile;
    private final List<String> given;
    private final String title;

    /** @param given the render options that were given, word by word */
    TradeOutput(Terminal terminal, Path folder, Path sceneFile, List<String> given, String title) {
        this.terminal = terminal;
        this.folder = folder;
        this.sceneFile = sceneFile;
        this.given = given;
        this.title = title.isEmpty() ? FileNames.stem(sceneFile) : title;
    }

    /** The names of all files that the trade and this may write into the folder. */
    static List<String> names(TradeSettings settings) {
        List<String> names = new ArrayList<>(Trade.files(settings));
        names.addAll(List.of(FIGURES, SUMMARY, PAGE));
        TradeCharts.names(settings).forEach(chart -> names.addAll(List.of(chart + ".png", chart + ".svg")));
        return names;
    }

    /** Writes it all; returns what was made of the measurements. */
    TradeAnalysis write(TradeResult measured) throws IOException {
        TradeAnalysis result = TradeAnalysis.of(measured);
        EqualTimeComparison equalTime = EqualTimeComparison.read(folder, measured);
        WholeFile.write(folder.resolve(FIGURES), TradeJson.of(result, equalTime));
        WholeFile.write(folder.resolve(SUMMARY), TradeSummary.of(result));
        List<Chart> charts = charts(result);
        WholeFile.write(folder.resolve(PAGE), TradePage.of(result, equalTime, context(), charts));
        Verdict headline = Verdict.headline(result);
        MethodChoice choice = MethodChoice.of(result);
        choice.sentence().ifPresent(terminal::show);
        choice.leftOut().forEach(spot -> terminal.show("Left out: " + spot + "."));
        terminal.show(headline.sentence());
        headline.best()
                .filter(CostEstimate::isMeasured)
                .ifPresent(b -> terminal.show("  " + context().render(b, result.settings())));
        for (Verdict v : Verdict.all(result)) {
            if (v.target() != headline.target()) {
                terminal.show(v.sentence());
            }
        }
        equalTime.sentence().ifPresent(terminal::show);
        terminal.show(result.referenceSentence());
        terminal.show("All of it: " + folder.resolve(PAGE));
        return result;
    }

    /** A machine without fonts, as some small containers are, draws no charts; all else is worth having. */
    private List<Chart> charts(TradeAnalysis result) throws IOException {
        Optional<String> whyNot = TradeCharts.whyNot();
        if (whyNot.isPresent()) {
            terminal.say("there are no charts: " + whyNot.get());
            return List.of();
        }
        List<Chart> charts = TradeCharts.of(result);
        for (Chart chart : charts) {
            ImageFiles.writePng(chart.image(), folder.resolve(chart.name() + ".png"));
            WholeFile.write(folder.resolve(chart.name() + ".svg"), chart.svg());
        }
        return charts;
    }

    private PageContext context() {
        return new PageContext(title, renderCommand(), compareCommand(), tradeCommand());
    }

    private String renderCommand() {
        return Launcher.command() + " render " + Shell.quoted(sceneFile.toString()) + " -o "
                + Shell.quoted(FileNames.stem(sceneFile) + ".png") + options();
    }

    private String compareCommand() {
        return Launcher.command() + " compare " + Shell.quoted(FileNames.stem(sceneFile) + ".png") + " "
                + Shell.quoted(folder.resolve("reference.pfm").toString());
    }

    private String tradeCommand() {
        return Launcher.command() + " trade " + Shell.quoted(sceneFile.toString()) + " -o "
                + Shell.quoted(folder.toString()) + options();
    }

    private String options() {
        StringBuilder text = new StringBuilder();
        given.forEach(g -> text.append(' ').append(Shell.quoted(g)));
        return text.toString();
    }
}
