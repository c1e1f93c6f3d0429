package growth
{
    import evaluation.pairs.SeededRandom;
    import starlogo.GreatLand;
    import starlogo.fitting.CapsuleFitter;
    import starlogo.fitting.Fitter;
    import starlogo.fitting.MinimalCapsuleFitter;
    import starlogo.fitting.MinimalSphereFitter;
    import starlogo.fitting.OrientedBoxFitter;
    import starlogo.fitting.RitterSphereFitter;
    import starlogo.fitting.ZAlignedBoxFitter;
    import starlogo.models.Model;
    import starlogo.models.ModelLoader;
    import support.SolidModels;

    /** What is computed of models: hulls, structures, hierarchies, surfaces. */
    public final class ShapeRows
    {
        /** All rows. */
        public static function get all():Array
        {
            return [
                    new GrowthRow("model: a closed curve", "vertices", 2000, 40000, beginModel(curve)),
                    new GrowthRow("model: two skew arcs", "vertices", 2000, 40000, beginModel(arcs)),
                    new GrowthRow("model: a skew plane", "vertices", 4000, 80000, beginModel(plane)),
                    new GrowthRow("model: a skew plane, exact", "vertices", 4000, 80000, beginModel(plane, true)),
                    new GrowthRow("model: two rings", "vertices", 2000, 40000, beginModel(rings)),
                    new GrowthRow("model: triangles at one edge, exact", "triangles", 2000, 80000, beginModel(edgeFan, true)),
                    new GrowthRow("model: triangles at one vertex, exact", "triangles", 2000, 80000, beginModel(vertexFan, true)),
                    new GrowthRow("model: copies of a triangle, exact", "triangles", 2000, 80000, beginModel(copies, true)),
                    new GrowthRow("model: pieces from 1e-6 to 1e6, exact", "pieces", 500, 20000, beginModel(geometricRow, true)),
                    new GrowthRow("model: cavities in cavities, exact", "pieces", 100, 1600, beginModel(cavities, true)),
                    new GrowthRow("model: boxes edge to edge, turned in and out, exact", "pieces", 200, 8000, beginModel(boxes, true)).from(800),
                    new GrowthRow("model: equal triangles, exact", "triangles", 2000, 80000, beginModel(equals, true)),
                    new GrowthRow("model: loose triangles at one vertex, exact", "triangles", 2000, 80000, beginModel(looseFan, true)),
                    new GrowthRow("model: a circle, all fits", "vertices", 250, 80000, beginFits(circle)).from(2000),
                    new GrowthRow("model: a moment curve, all fits", "vertices", 250, 80000, beginFits(momentCurve)).from(2000),
                    new GrowthRow("model: a paraboloid, all fits", "vertices", 250, 80000, beginFits(paraboloid)).from(2000),
                    new GrowthRow("model: loads cancelled by name", "loads", 200, 200000, beginCancelled),
                    new GrowthRow("model: loads asked for by name", "loads", 200, 200000, beginPending),
                    new GrowthRow("model: unknown names", "names", 10000, 600000, beginNames)];
        }

        // Asks for n models that are not there.
        private static function beginNames(n:int, row:GrowthRow):Function
        {
            return function():Object
            {
                var greatLand:GreatLand = new GreatLand();
                for (var i:int = 0; i < n; i++)
                {
                    greatLand.hasModel("unknown " + i);
                }
                return greatLand;
            };
        }

        // The loads are cancelled in another order than they began.
        private static function beginCancelled(n:int, row:GrowthRow):Function
        {
            return function():Object
            {
                var loader:ModelLoader = loading(n);
                for (var i:int = 0; i < n; i++)
                {
                    loader.cancel("m" + (i % 2 == 0 ? i : n - i));
                }
                loader.cancel();
                return loader;
            };
        }

        private static function beginPending(n:int, row:GrowthRow):Function
        {
            return function():Object
            {
                var loader:ModelLoader = loading(n);
                for (var i:int = 0; i < n; i++)
                {
                    loader.isPending("m" + i);
                }
                loader.cancel();
                return loader;
            };
        }

        private static function loading(n:int):ModelLoader
        {
            var loader:ModelLoader = new ModelLoader(new GreatLand());
            for (var i:int = 0; i < n; i++)
            {
                loader.loadText("m" + i, "v 0 0 0");
            }
            return loader;
        }

        // Fits structures of all kinds around n vertices.
        private static function beginFits(make:Function):Function
        {
            return function(n:int, row:GrowthRow):Function
            {
                var vertices:Vector.<Number> = new Model("a", make(n)).vertices;
                return function():Object
                {
                    var fits:Array = [];
                    for each (var fitter:Fitter in [new RitterSphereFitter(), new MinimalSphereFitter(), new MinimalCapsuleFitter(),
                                new ZAlignedBoxFitter(10), new CapsuleFitter(new OrientedBoxFitter(10))])
                    {
                        fits.push(fitter.fit(vertices));
                    }
                    return fits;
                };
            };
        }

        // Adds a model of n vertices to a game.
        private static function beginModel(make:Function, isExact:Boolean = false):Function
        {
            return function(n:int, row:GrowthRow):Function
            {
                var model:Model = make(n);
                return function():Object
                {
                    var greatLand:GreatLand = new GreatLand();
                    greatLand.prepareExact = isExact;
                    greatLand.addModel(model);
                    return greatLand;
                };
            };
        }

        // A smooth closed curve in space: every vertex is on the hull.
        private static function curve(n:int):Model
        {
            var points:Vector.<Number> = new Vector.<Number>();
            for (var i:int = 0; i < n; i++)
            {
                var angle:Number = 2 * Math.PI * i / n;
                points.push(Math.cos(angle), Math.sin(angle), 0.3 * Math.cos(2 * angle));
            }
            return new Model("a", points);
        }

        private static function circle(n:int):Vector.<Number>
        {
            var points:Vector.<Number> = new Vector.<Number>();
            for (var i:int = 0; i < n; i++)
            {
                var angle:Number = 2 * Math.PI * i / n;
                points.push(Math.cos(angle), Math.sin(angle), 0);
            }
            return points;
        }

        // Every vertex is on the hull, and the hull has an edge from each vertex to the first and the last one.
        private static function momentCurve(n:int):Vector.<Number>
        {
            var points:Vector.<Number> = new Vector.<Number>();
            for (var i:int = 0; i < n; i++)
            {
                var t:Number = 2 * i / n - 1;
                points.push(t, t * t, t * t * t);
            }
            return points;
        }

        private static function paraboloid(n:int):Vector.<Number>
        {
            var random:SeededRandom = new SeededRandom(2);
            var points:Vector.<Number> = new Vector.<Number>();
            for (var i:int = 0; i < n; i++)
            {
                var x:Number = random.between(-1, 1);
                var y:Number = random.between(-1, 1);
                points.push(x, y, x * x + y * y);
            }
            return points;
        }

        private static function arcs(n:int):Model
        {
            var points:Vector.<Number> = new Vector.<Number>();
            for (var i:int = 0; i < n; i++)
            {
                var angle:Number = Math.PI * i / n;
                if ((i & 1) == 0)
                {
                    points.push(Math.cos(angle), Math.sin(angle), 0);
                }
                else
                {
                    points.push(0.2, Math.cos(angle), 2 - Math.sin(angle));
                }
            }
            return new Model("a", points);
        }

        private static function rings(n:int):Model
        {
            var points:Vector.<Number> = new Vector.<Number>();
            for (var i:int = 0; i < n; i++)
            {
                var angle:Number = 2 * Math.PI * int(i / 2) / int(n / 2);
                points.push(Math.cos(angle), Math.sin(angle), i & 1);
            }
            return new Model("a", points);
        }

        private static function edgeFan(n:int):Model
        {
            var points:Vector.<Number> = new <Number>[0, 0, 0, 0, 0, 1];
            var corners:Vector.<uint> = new Vector.<uint>();
            for (var i:int = 0; i < n; i++)
            {
                var angle:Number = 2 * Math.PI * i / n;
                points.push(Math.cos(angle), Math.sin(angle), 0.5);
                corners.push(0, 1, 2 + i);
            }
            return new Model("a", points, corners);
        }

        private static function vertexFan(n:int):Model
        {
            var points:Vector.<Number> = new <Number>[0, 0, 1];
            var corners:Vector.<uint> = new Vector.<uint>();
            for (var i:int = 0; i < n; i++)
            {
                var angle:Number = 2 * Math.PI * i / n;
                points.push(Math.cos(angle), Math.sin(angle), 0);
                corners.push(0, 1 + i, 1 + (i + 1) % n);
            }
            return new Model("a", points, corners);
        }

        // The triangles share a vertex, and no edge.
        private static function looseFan(n:int):Model
        {
            var random:SeededRandom = new SeededRandom(3);
            var points:Vector.<Number> = new <Number>[0, 0, 0];
            var corners:Vector.<uint> = new Vector.<uint>();
            for (var i:int = 0; i < n; i++)
            {
                for (var k:int = 0; k < 6; k++)
                {
                    points.push(random.between(-1, 1));
                }
                corners.push(0, 1 + 2 * i, 2 + 2 * i);
            }
            return new Model("a", points, corners);
        }

        private static function equals(n:int):Model
        {
            var corners:Vector.<uint> = new Vector.<uint>();
            for (var i:int = 0; i < n; i++)
            {
                corners.push(0, 1, 2);
            }
            return new Model("a", new <Number>[0, 0, 0, 1, 0, 0, 0, 1, 0], corners);
        }

        private static function copies(n:int):Model
        {
            var corners:Vector.<uint> = new Vector.<uint>();
            for (var i:int = 0; i < n; i++)
            {
                corners.push(0, i % 3 == 0 ? 1 : 2, i % 3 == 0 ? 2 : 1);
            }
            return new Model("a", new <Number>[0, 0, 0, 1, 0, 0, 0, 1, 0], corners);
        }

        private static function geometricRow(n:int):Model
        {
            return pieces(n, function(i:int):Array
                {
                    var size:Number = Math.pow(10, 12 * i / n - 6);
                    return [0.2 * size, size, size * (i % 7) / 7, size * (i % 3) / 3, false];
                });
        }

        private static function cavities(n:int):Model
        {
            return pieces(n, function(i:int):Array
                {
                    var size:Number = 1 - i / n;
                    return [size, 0, 0, -size / 2, i % 2 == 1];
                });
        }

        private static function boxes(n:int):Model
        {
            var side:int = Math.sqrt(n);
            return pieces(side * side, function(i:int):Array
                {
                    return [1, i % side, int(i / side), (i + int(i / side)) % 2, i % 3 == 1];
                });
        }

        // Cubes. of(i) has size, x, y, z, and whether it is turned inside out.
        private static function pieces(n:int, of:Function):Model
        {
            var cubes:Array = [];
            for (var i:int = 0; i < n; i++)
            {
                cubes.push(of(i));
            }
            return SolidModels.of("a", cubes, Model.AS_GIVEN);
        }

        // A square grid of triangles in the plane x + y + z = 0.
        private static function plane(n:int):Model
        {
            var side:int = Math.max(2, Math.sqrt(n));
            var points:Vector.<Number> = new Vector.<Number>();
            var corners:Vector.<uint> = new Vector.<uint>();
            for (var row:int = 0; row < side; row++)
            {
                for (var column:int = 0; column < side; column++)
                {
                    points.push(row, column, -row - column);
                    if (row > 0 && column > 0)
                    {
                        var corner:int = row * side + column;
                        corners.push(corner, corner - 1, corner - side - 1, corner, corner - side - 1, corner - side);
                    }
                }
            }
            return new Model("a", points, corners);
        }
    }
}
