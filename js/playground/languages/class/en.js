/** The words of the teacher's pages and of handing in, in English. They load with those pages. */
const count = (number, one, many) => `${number.toLocaleString("en")} ${number === 1 ? one : many}`;

export const texts = {
	teach: {
		title: "Eleven lessons for a class", intro: (minutes) => `For pupils from twelve on, alone or in pairs: ${minutes} minutes in all. Nobody needs an account.`,
		lesson: "Lesson", minutes: "Minutes", inPlay: "In Play", open: "Open", numbered: (number, title) => `${number}. ${title}`,
		pageOf: (number) => `Page to print of lesson ${number}`, openOf: (number) => `Open lesson ${number}`,
		all: "All lessons", allSheets: "All sheets, to print at once", sheetsNote: "The page of each lesson, with its solution on a second one. The list below leads to single ones.", print: "Print", of: (number, all, minutes) => `Lesson ${number} of ${all}, ${minutes} minutes`,
		aim: "What pupils learn", told: "What the lesson says", ask: "To talk about", solution: "A solution",
		withSolution: "With the solution on a second page", why: "Why", blocks: "The blocks", backToPlay: "Back to the program", noPage: "There is no such page here. These are the lessons.", solved: (title) => `The blocks of “${title}”, solved`,
		classNote: "See who has solved what, and play every program.",
		picture: (title) => `How “${title}” begins`, program: (title) => `The blocks of “${title}” as they are given`, given: "The blocks at the beginning",
		list: {
			blocks: { aim: "A script runs for each agent, many times a second. The order of blocks is the order of what happens.", ask: "The script has no loop, and yet the turtles keep walking. Why?", solution: "Put “forward” below “turn” in the script “every frame, each of turtles”." },
			helmet: { aim: "A computer tests simple shapes in place of models, so it can miss a touch.", ask: "Where else do people look only roughly, to be quicker?", solution: "Choose any other system above the world. The ball then bounces off the helmet." },
			wing: { aim: "A shape that holds all of a model also holds air: a false collision.", ask: "Which is worse in a game, a false collision or a missed one?", solution: "Choose “Hierarchies” or “Exact” above the world. The dragon then does not turn red." },
			main: { aim: "Precision costs time. A program can spend it where the player looks.", ask: "For which characters of a game that you know should the test be exact?", solution: "Put “set hierarchical of all dragons to on” into the script of the start, below “use collision system”." },
			fast: { aim: "A computer sees the world in frames. Between two of them much can happen.", ask: "A film has 24 pictures a second. What does it miss?", solution: "Put “collide along the way, all paintballs: on” into the script of the start." },
			starts: { aim: "A touch lasts for many frames. The start of a touch happens once.", ask: "A door bell rings once, no matter how long you press it. How does it know?", solution: "Replace “on collision” by “when touching starts: turtles with walls”, with the same block inside." },
			room: { aim: "The engine only reports a touch. The program decides what happens then.", ask: "In which games may one walk through things, and why?", solution: "Add “on collision of bears with walls do”, and put “bounce off” into it." },
			near: { aim: "Agents can count the others within a distance.", ask: "What does it cost to ask this for each of a thousand agents?", solution: "Put “say”, with “count of turtles within 5” in it, into a script “every frame, each of bears”." },
			see: { aim: "“Is it near?” and “Can I see it?” are different questions, because a wall can hide things.", ask: "Can the turtle see the bear whenever the bear sees the turtle?", solution: "Put “say”, with “I can see nearest of turtles within 20” in it, into a script “every frame, each of bears”." },
			hunt: { aim: "Senses, decisions and movement together make a character that seems to think.", ask: "Is the nearest turtle always the best one to chase?", solution: "Put “turn towards”, with “nearest of turtles within 50” in it, above “forward”, and let the bear go faster." },
			jump: { aim: "A platform game needs three things of its world: floors, gravity and a jump from a floor.", ask: "Why does the bear jump only if it stands? What would the game be like otherwise?", solution: "Put “nobody goes through platforms: on” into the start, and “jump 2 high” and “fall” below “walk”." },
		},
	},
	/** How a class gets the page. */
	inClass: {
		title: "In class", note: "How pupils get the page, from a server or from a stick, by a link or a QR code.",
		intro: "Nothing is installed, and nobody needs an account. The page is a folder of files, or one file. It loads nothing from elsewhere and sends nothing away.",
		links: "Links and QR codes", linksNote: "Choose what opens. Show the code on the wall, print it, or send the link.",
		line: "Line for the terminal", address: "Address of the page", place: "What opens", qr: "QR code of the link",
		noAddress: "Write the address at which your class opens this page. It begins with http.",
		onlyHere: "Only this computer opens this address. Write the one that it has in your network, for example http://192.168.0.10:8080/. The steps below find it.",
		server: "From a web server", serverNote: "Any web server will do, also your school’s: copy the folder “playground” of the release to it. Or your own computer serves it. Open a terminal in this folder and write one of these lines:",
		serverSteps: ["Find your computer’s address in the network: “ipconfig” in Windows, “ifconfig” in macOS, “hostname -I” in Linux.", "Pupils in the same network open http://, this address and :8080/.", "If they cannot open it, your computer’s firewall has to allow it, or the network keeps computers apart. Then use a stick."],
		antw: "If you have the project’s sources, write this instead. It prints the addresses and a QR code:",
		stick: "From a stick, without a network", stickSteps: ["Copy “starlogo-nova.html” onto a stick. It is the whole page.", "Copy it from there onto each computer and open it by a double click.", "Pupils choose a lesson on the first screen. Each browser keeps its own programs. “Hand in…” gives you a file of them."],
		file: "Download starlogo-nova.html",
	},
	/** A pupil's work, which goes to the teacher, and the page of a class. */
	handing: {
		title: "Hand in your work", name: "Name", needsName: "Write your name first.",
		what: (lessons, programs, games) => `This gives your teacher all of your work: ${games > 0 ? `${count(games, "game", "games")} that you have won, ` : ""}${count(lessons, "lesson", "lessons")} that you have done and ${count(programs, "program", "programs")}.`,
		noWork: "You have nothing to hand in yet. Do a lesson, win a game, or change a program.",
		save: "Save a file", copy: "Copy a code", code: "The code", how: "Give the file to your teacher, or send the code in a message. Nothing is sent by itself.",
		fileName: (pupil) => `${pupil} – StarLogo.json`, saved: (file) => `“${file}” is in your downloads. Give it to your teacher.`,
		copied: (letters) => `The code is on the clipboard (${letters} letters). Paste it into a message to your teacher.`, notCopied: "Copy this code by hand, and send it to your teacher.",
		nextNote: (lessons, programs) => `Is somebody else here now? This browser forgets everything of the last pupil: ${count(lessons, "lesson", "lessons")} done, ${count(programs, "program", "programs")}, all models and the name. This cannot be undone.`,
		handFirst: "Hand in first", forget: "Forget everything",
		classTitle: "The work of a class", classSteps: ["Pupils press “Hand in…” in the menu of Play. They save a file, or copy a code.", "Open all of their files here at once, drop them on this page, or paste the codes.", "The page plays every program, and a table shows who has solved what. This browser keeps the works until you remove them. They go nowhere else."],
		csv: "Download the table", when: "Handed in", earlier: (works) => `Handed in before: ${count(works, "work", "works")}`, openFiles: "Open files…", codeHere: "Or paste codes here", takeCode: "Take the codes", nothing: "Nothing is open yet.",
		taken: (added, again) => `${count(added, "work is", "works are")} new.${again > 0 ? ` ${count(again, "was", "were")} here already.` : ""}`, broken: (files) => `No work of this page: ${files}.`, brokenCode: "No whole code is in this text. Copy all of it, from SL1 on.",
		table: "Who has solved what", pupil: "Pupil", games: "Games won", programs: "Programs", all: (pupils) => `All ${pupils}`, tried: "begun", signs: "✓ solved: this page has played it. ✓? solved as the file says, but none of its programs does it. ? solved as the file says, but this page has not played it. … begun. A click on a name, a sign or a picture plays the program. If somebody has handed in twice, the newest work counts.",
		forgetClass: "Remove all…", askForget: (count) => `This removes the works of all ${count} pupils from this browser. It cannot be undone.`, notSeen: "solved as the file says, but none of its programs does it", notPlayed: "solved as the file says; not played", notKept: "This browser does not keep them: they are here as long as the page is open.",
		remove: (pupil) => `Remove the work of ${pupil}`, noPrograms: "No programs.",
	},
};
