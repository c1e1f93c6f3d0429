package growth
{
    import starlogo.GreatLand;
    import starlogo.models.Model;

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
                    new GrowthRow("model: a skew plane, exact", "vertices", 4000, 80000, beginModel(plane, true))];
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
