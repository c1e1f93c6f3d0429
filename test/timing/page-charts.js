// Runs in the page, after the chart library: draws `charts`, in the colours of the style's variables.

const dark = window.matchMedia('(prefers-color-scheme: dark)');
const drawn = [];

function color(name) {
	return getComputedStyle(document.documentElement).getPropertyValue(`--${name}`).trim();
}

function compact(value) {
	if (value === null) {
		return '';
	}
	return value >= 1000 ? Math.round(value).toLocaleString('en') : String(Number(value.toPrecision(3)));
}

// From the power of ten below the least, with room for its bar, to above the greatest.
function logarithmic(title, values) {
	const found = values.filter((value) => value > 0);
	return {
		type: 'logarithmic',
		min: 10 ** Math.floor(Math.log10(Math.min(...found)) - 0.15),
		max: Math.max(...found) * 1.5,
		title: { display: true, text: `${title} (log scale)`, color: color('quiet') },
		grid: { color: color('grid') },
		border: { color: color('grid') },
		// powers of ten alone: the marks between them crowd, unless there are few
		ticks: { color: color('quiet'), callback: (value) => (isMark(value, Math.max(...found) / Math.min(...found)) ? compact(value) : null) },
	};
}

// Whether an axis of values that differ so many times has a mark at a value.
function isMark(value, times) {
	const first = value / 10 ** Math.floor(Math.log10(value) + 1e-9);
	return (times < 30 ? [1, 2, 5] : [1]).some((each) => Math.abs(first - each) < 1e-6);
}

// A dashed line across at a value. The legend has its name, because bars stand everywhere else.
const limit = {
	id: 'limit',
	afterDatasetsDraw(chart, _, { at }) {
		const { ctx, chartArea: { left, right, top, bottom }, scales: { y } } = chart;
		const height = at === undefined ? NaN : y.getPixelForValue(at);
		if (!(height >= top && height <= bottom)) {
			return;
		}
		ctx.save();
		ctx.strokeStyle = color('limit');
		ctx.setLineDash([5, 4]);
		ctx.beginPath();
		ctx.moveTo(left, height);
		ctx.lineTo(right, height);
		ctx.stroke();
		ctx.restore();
	},
};

// The number of each bar above it, if all have room beside one another.
const numbers = {
	id: 'numbers',
	afterDatasetsDraw(chart, _, { kind, series }) {
		const { ctx } = chart;
		ctx.save();
		ctx.font = '10px system-ui, sans-serif';
		ctx.textAlign = 'center';
		ctx.textBaseline = 'bottom';
		ctx.fillStyle = color('quiet');
		const shown = kind === 'bars' ? series.flatMap(({ values }, i) => (chart.isDatasetVisible(i)
			? chart.getDatasetMeta(i).data.map((bar, at) => ({ bar, text: compact(values[at]), value: values[at] })) : [])).filter(({ value }) => value !== null) : [];
		if (shown.every(({ bar, text }) => ctx.measureText(text).width <= bar.width * 1.1)) {
			for (const { bar, text } of shown) ctx.fillText(text, bar.x, bar.y - 3);
		}
		ctx.restore();
	},
};

// A cross at the foot of each number that was refused: in the place of its bar, or above its number of agents.
const refused = {
	id: 'refused',
	afterDatasetsDraw(chart, _, { kind, series }) {
		const { ctx, chartArea: { bottom, left, right }, scales: { x } } = chart;
		const counts = {};
		ctx.save();
		ctx.font = 'bold 13px system-ui, sans-serif';
		ctx.textAlign = 'center';
		series.forEach((one, i) => {
			if (!chart.isDatasetVisible(i)) {
				return;
			}
			ctx.fillStyle = color(one.color);
			if (kind === 'bars') {
				one.refused?.forEach((isRefused, at) => isRefused && ctx.fillText('×', chart.getDatasetMeta(i).data[at].x, bottom - 3));
			} else {
				// several stand side by side, towards the middle
				one.refused.forEach((agents) => {
					const place = x.getPixelForValue(agents);
					counts[agents] = (counts[agents] ?? -1) + 1;
					ctx.fillText('×', place + (place < (left + right) / 2 ? 10 : -10) * counts[agents], bottom - 3);
				});
			}
		});
		ctx.restore();
	},
};

/** The legend's labels: of the series, and of the line across. */
const labelsOf = (chart) => (drawnChart) => {
	const labels = Chart.defaults.plugins.legend.labels.generateLabels(drawnChart);
	return chart.line ? [...labels, { text: chart.line[1], fontColor: color('limit'), strokeStyle: color('limit'), lineWidth: 2, lineDash: [3, 2], pointStyle: 'line' }] : labels;
};

function common(chart) {
	return {
		animation: false,
		responsive: true,
		maintainAspectRatio: false,
		plugins: {
			legend: {
				position: 'top', align: 'start', labels: { color: color('text'), usePointStyle: true, boxHeight: 8, padding: 18, generateLabels: labelsOf(chart) },
				onClick: (event, item, legend) => item.datasetIndex !== undefined && Chart.defaults.plugins.legend.onClick.call(legend, event, item, legend),
			},
			tooltip: { callbacks: { label: (item) => `${item.dataset.label}: ${compact(item.parsed.y)} ${chart.unit}` } },
			limit: chart.line ? { at: chart.line[0] } : {},
			refused: { kind: chart.kind, series: chart.series },
			numbers: { kind: chart.kind, series: chart.series },
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
				y: logarithmic(chart.unit, chart.series.flatMap((series) => series.values)),
			},
		},
		plugins: [limit, refused, numbers],
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
		plugins: [limit, refused],
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
