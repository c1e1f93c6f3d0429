/** The words of the teacher's pages and of handing in, in German. */
const count = (number, one, many) => `${number.toLocaleString("de")} ${number === 1 ? one : many}`;

export const texts = {
	teach: {
		title: "Elf Lektionen für eine Klasse", intro: (lessons, minutes) => `${lessons} Lektionen für Kinder ab zwölf Jahren, die allein oder zu zweit arbeiten. Zusammen dauern sie ${minutes} Minuten. Niemand braucht ein Konto: Schicken Sie der Klasse den Link einer Lektion oder schreiben Sie ihn an die Tafel.`,
		lesson: "Lektion", minutes: "Minuten", page: "Seite zum Drucken", open: "Öffnen", numbered: (number, title) => `${number}. ${title}`,
		pageOf: (number) => `Seite zum Drucken von Lektion ${number}`, openOf: (number) => `Lektion ${number} öffnen`,
		all: "Alle Lektionen", allSheets: "Alle Blätter, auf einmal zu drucken", print: "Drucken", of: (number, all, minutes) => `Lektion ${number} von ${all}, ${minutes} Minuten`,
		aim: "Was gelernt wird", told: "Was die Lektion sagt", ask: "Zum Reden", solution: "Eine Lösung",
		withSolution: "Mit der Lösung auf einer zweiten Seite", why: "Warum", blocks: "Die Blöcke", backToPlay: "Zurück zum Programm", noPage: "Diese Seite gibt es hier nicht. Das sind die Lektionen.", solved: (title) => `Die Blöcke von „${title}“, gelöst`,
		classNote: "Sehen Sie, wer was gelöst hat, und spielen Sie jedes Programm.",
		picture: (title) => `So beginnt „${title}“`, program: (title) => `Die Blöcke von „${title}“, wie sie gegeben sind`, given: "Die gegebenen Blöcke",
		list: {
			blocks: { aim: "Ein Skript läuft für jeden Agenten, viele Male in der Sekunde. Die Reihenfolge der Blöcke ist die Reihenfolge dessen, was geschieht.", ask: "Das Skript hat keine Schleife, und doch laufen die Schildkröten immer weiter. Warum?", solution: "Setze „vorwärts“ unter „drehe“ in das Skript „in jedem Bild, für alle Schildkröten“." },
			helmet: { aim: "Ein Computer testet einfache Formen statt der Modelle. Darum kann er eine Berührung verpassen.", ask: "Wo sieht sonst noch jemand nur ungefähr hin, um schneller zu sein?", solution: "Wähle über der Welt irgendein anderes System. Dann prallt die Kugel vom Helm ab." },
			wing: { aim: "Eine Form, die das ganze Modell fasst, fasst auch Luft: eine falsche Kollision.", ask: "Was ist in einem Spiel schlimmer, eine falsche Kollision oder eine verpasste?", solution: "Wähle über der Welt „Hierarchien“ oder „Exakt“. Dann wird der Drache nicht rot." },
			main: { aim: "Genauigkeit kostet Zeit. Ein Programm kann sie dort ausgeben, wo jemand hinsieht.", ask: "Bei welchen Figuren eines Spiels, das du kennst, sollte der Test genau sein?", solution: "Setze „setze hierarchisch für alle Drachen auf ein“ in das Skript vom Beginn, unter „nimm Kollisionssystem“." },
			fast: { aim: "Ein Computer sieht die Welt in Bildern. Zwischen zweien kann viel geschehen.", ask: "Ein Film hat 24 Bilder in der Sekunde. Was verpasst er?", solution: "Setze „Kollision auf dem ganzen Weg für alle Farbkugeln: ein“ in das Skript vom Beginn." },
			starts: { aim: "Eine Berührung dauert viele Bilder. Sie beginnt nur einmal.", ask: "Eine Türklingel läutet einmal, so lange man auch drückt. Woher weiß sie das?", solution: "Ersetze „bei Kollision“ durch „wenn Berührung beginnt: Schildkröten und Wände“, mit demselben Block darin." },
			room: { aim: "Die Engine meldet eine Berührung nur. Das Programm sagt, was daraus folgt.", ask: "In welchen Spielen darf man durch Dinge laufen, und warum?", solution: "Nimm „bei Kollision: Bären und Wände“ dazu und setze „pralle ab“ hinein." },
			near: { aim: "Agenten können andere danach zählen, wie weit weg sie sind.", ask: "Was kostet es, das für jeden von tausend Agenten zu fragen?", solution: "Setze „sage“ mit „Anzahl: Schildkröten im Umkreis 5“ darin in ein Skript „in jedem Bild, für alle Bären“." },
			see: { aim: "Nah sein und gesehen werden sind zwei Fragen: Eine Wand verbirgt.", ask: "Sieht die Schildkröte den Bären immer dann, wenn er sie sieht?", solution: "Setze „sage“ mit „ich sehe Nächsten von Schildkröten im Umkreis 20“ darin in ein Skript „in jedem Bild, für alle Bären“." },
			hunt: { aim: "Sinne, Entscheidungen und Bewegung ergeben zusammen eine Figur, die zu denken scheint.", ask: "Ist die nächste Schildkröte immer die beste für eine Jagd?", solution: "Setze „drehe auf … zu“ mit „Nächsten von Schildkröten im Umkreis 50“ über „vorwärts“ und lass den Bären schneller laufen." },
			jump: { aim: "Ein Hüpfspiel braucht drei Dinge von seiner Welt: Böden, Schwerkraft und einen Sprung vom Boden.", ask: "Warum springt der Bär nur, wenn er steht? Wie wäre das Spiel sonst?", solution: "Setze „niemand geht durch Plattformen: ein“ in den Start und „springe 2 hoch“ und „falle“ unter „gehe“." },
		},
	},
	handing: {
		title: "Gib deine Arbeit ab", name: "Name", needsName: "Schreib zuerst deinen Namen.",
		what: (lessons, programs) => `So bekommt deine Lehrkraft alles von dir: ${count(lessons, "geschaffte Lektion", "geschaffte Lektionen")} und ${count(programs, "Programm", "Programme")}.`,
		save: "Datei speichern", copy: "Code kopieren", code: "Der Code", how: "Gib deiner Lehrkraft die Datei oder schick ihr den Code in einer Nachricht. Von selbst wird nichts verschickt.",
		fileName: (pupil) => `${pupil} – StarLogo.json`, saved: (file) => `„${file}“ ist bei deinen Downloads. Gib die Datei deiner Lehrkraft.`,
		copied: (letters) => `Der Code ist in der Zwischenablage (${letters} Zeichen). Füge ihn in eine Nachricht an deine Lehrkraft ein.`, notCopied: "Kopiere diesen Code von Hand und schick ihn deiner Lehrkraft.",
		nextNote: (lessons, programs) => `Ist jetzt jemand anders hier? Dann vergisst dieser Browser alles von vorher: ${count(lessons, "geschaffte Lektion", "geschaffte Lektionen")}, ${count(programs, "Programm", "Programme")}, alle Modelle und den Namen. Das lässt sich nicht rückgängig machen.`,
		handFirst: "Erst abgeben", forget: "Alles vergessen",
		classTitle: "Die Arbeiten einer Klasse", classNote: "In „Spielen“ drücken alle auf „Abgeben …“. Öffnen Sie hier die Dateien, alle auf einmal, oder fügen Sie die Codes ein. Dieser Browser behält sie, bis Sie sie entfernen. Sie gehen nirgendwohin.",
		csv: "Tabelle herunterladen", when: "Abgegeben", earlier: (works) => `Vorher abgegeben: ${count(works, "Arbeit", "Arbeiten")}`, openFiles: "Dateien öffnen …", codeHere: "Oder Codes hier einfügen", takeCode: "Codes übernehmen", nothing: "Noch ist nichts geöffnet. Dateien lassen sich auch hier ablegen.",
		taken: (added, again) => `${count(added, "Arbeit ist", "Arbeiten sind")} neu.${again > 0 ? ` ${count(again, "war", "waren")} schon da.` : ""}`, broken: (files) => `Keine Arbeit von dieser Seite: ${files}.`, brokenCode: "In diesem Text ist kein ganzer Code. Kopieren Sie alles ab SL1.",
		table: "Wer was gelöst hat", pupil: "Wer", games: "Gewonnene Spiele", programs: "Programme", all: (pupils) => `Alle ${pupils}`, tried: "begonnen", signs: "✓ gelöst: Diese Seite hat es gespielt. ✓? gelöst, sagt die Datei, aber keines der Programme tut es. ? gelöst, sagt die Datei, aber diese Seite hat es nicht gespielt. … begonnen. Ein Klick auf einen Namen, ein Zeichen oder ein Bild spielt das Programm. Wer zweimal abgegeben hat, für den zählt die neueste Arbeit.",
		forgetClass: "Alle entfernen …", askForget: (count) => `Das entfernt die Arbeiten von allen ${count} aus diesem Browser. Es lässt sich nicht rückgängig machen.`, notSeen: "gelöst, sagt die Datei, aber keines der Programme tut es", notPlayed: "gelöst, sagt die Datei; nicht gespielt", notKept: "Dieser Browser behält sie nicht: Sie sind da, solange die Seite offen ist.",
		remove: (pupil) => `Die Arbeit von ${pupil} entfernen`, noPrograms: "Keine Programme.",
	},
};
