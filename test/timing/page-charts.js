// Runs in the page, after the chart library: draws `charts`, in the colours of the style's variables.

const dark = window.matchMedia('(prefers-color-scheme: dark)');
const drawn = [];

function color(name) {
	return getComputedStyle(document.documentElement).getPropertyValue(`--${name}`).trim();
}

function compact(value) {
	return value >= 1000 ? value.toLocaleString('en') : String(Number(value.toPrecision(3)));
}

// From the power of ten below the least, with room for its bar, to above the greatest.
function logarithmic(title, values) {
	const found = values.filter((value) => value > 0);
	return {
		type: 'logarithmic',
		min: 10 ** Math.floor(Math.log10(Math.min(...found)) - 0.15),
		max: Math.max(...found) * 1.3,
		title: { display: true, text: title, color: color('quiet') },
		grid: { color: color('grid') },
		border: { color: color('grid') },
		// powers of ten alone: the marks between them crowd
		ticks: { color: color('quiet'), callback: (value) => (Math.abs(Math.log10(value) - Math.round(Math.log10(value))) < 1e-6 ? compact(value) : null) },
	};
}

// A dashed line across at a value, with its name.
const limit = {
	id: 'limit',
	afterDatasetsDraw(chart, _, { at, name }) {
		const { ctx, chartArea: { left, right, top, bottom }, scales: { y } } = chart;
		const height = at === undefined ? NaN : y.getPixelForValue(at);
		if (!(height >= top && height <= bottom)) {
			return;
		}
		ctx.save();
		ctx.strokeStyle = ctx.fillStyle = color('limit');
		ctx.setLineDash([5, 4]);
		ctx.beginPath();
		ctx.moveTo(left, height);
		ctx.lineTo(right, height);
		ctx.stroke();
		ctx.font = '12px system-ui, sans-serif';
		ctx.textAlign = 'left';
		// bars may stand behind it
		ctx.fillStyle = color('card');
		ctx.fillRect(left + 5, height - 19, ctx.measureText(name).width + 6, 17);
		ctx.fillStyle = color('limit');
		ctx.fillText(name, left + 8, height - 6);
		ctx.restore();
	},
};

function common(chart) {
	return {
		animation: false,
		responsive: true,
		maintainAspectRatio: false,
		plugins: {
			legend: { position: 'top', align: 'start', labels: { color: color('text'), usePointStyle: true, boxHeight: 8, padding: 18 } },
			tooltip: { callbacks: { label: (item) => `${item.dataset.label}: ${compact(item.parsed.y)} ${chart.unit}` } },
			limit: chart.line ? { at: chart.line[0], name: chart.line[1] } : {},
		},
	};
}

function barChart(chart) {
	return {
		type: 'bar',
		data: {
			labels: chart.labels,
			datasets: chart.series.map((series) => ({
				label: series.name, data: series.values, backgroundColor: color(series.color), pointStyle: 'rectRounded',
				borderRadius: 3, categoryPercentage: 0.74, barPercentage: 0.92,
			})),
		},
		options: {
			...common(chart),
			scales: {
				x: { grid: { display: false }, border: { color: color('grid') }, ticks: { color: color('text'), autoSkip: false, maxRotation: 60, font: { size: chart.labels.length > 12 ? 10 : chart.labels.length > 10 ? 11 : 12 } } },
				y: chart.linear
					? { beginAtZero: true, title: { display: true, text: chart.unit, color: color('quiet') }, grid: { color: color('grid') }, ticks: { color: color('quiet') } }
					: logarithmic(chart.unit, chart.series.flatMap((series) => series.values)),
			},
		},
		plugins: [limit],
	};
}

function lineChart(chart) {
	const points = chart.series.flatMap((series) => series.points);
	return {
		type: 'scatter',
		data: {
			datasets: chart.series.map((series) => ({
				label: series.name, data: series.points, showLine: true, borderColor: color(series.color), backgroundColor: color(series.color),
				borderWidth: 2, borderDash: series.isDashed ? [6, 4] : [], pointRadius: 4, pointStyle: series.isDashed ? 'rect' : 'circle',
			})),
		},
		options: { ...common(chart), scales: {
				x: { ...logarithmic(chart.xUnit, points.map(({ x }) => x)), min: Math.min(...points.map(({ x }) => x)) * 0.9 },
				y: logarithmic(chart.unit, points.map(({ y }) => y)),
			},
		},
		plugins: [limit],
	};
}

function drawAll() {
	while (drawn.length > 0) {
		drawn.pop().destroy();
	}
	Chart.defaults.font.family = 'system-ui, sans-serif';
	Chart.defaults.font.size = 12;
	for (const [id, chart] of Object.entries(charts)) {
		drawn.push(new Chart(document.getElementById(id), chart.kind === 'bars' ? barChart(chart) : lineChart(chart)));
	}
}

drawAll();
dark.addEventListener('change', drawAll);
// on paper it is light
window.addEventListener('beforeprint', () => {
	document.documentElement.classList.add('paper');
	drawAll();
});
window.addEventListener('afterprint', () => {
	document.documentElement.classList.remove('paper');
	drawAll();
});
