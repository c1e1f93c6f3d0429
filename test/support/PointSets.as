package support
{
    import evaluation.pairs.SeededRandom;

    /** Sets of vertices (x, y, z each) that fits and hulls are tried on: shapes by formula, random ones, degenerate ones. */
    public final class PointSets
    {
        /** A box with corners at plus and minus the half-extents, each side divided into n by n squares. */
        public static function box(halfX:Number, halfY:Number, halfZ:Number, n:int = 1):Vector.<Number>
        {
            var points:Vector.<Number> = new Vector.<Number>();
            for (var i:int = 0; i <= n; i++)
            {
                for (var j:int = 0; j <= n; j++)
                {
                    for (var k:int = 0; k <= n; k++)
                    {
                        if (i % n == 0 || j % n == 0 || k % n == 0)
                        {
                            points.push(halfX * (2 * i / n - 1), halfY * (2 * j / n - 1), halfZ * (2 * k / n - 1));
                        }
                    }
                }
            }
            return points;
        }

        /** A cylinder along z from z = 0: rings of this many vertices, each ring once. */
        public static function cylinder(radius:Number, height:Number, segments:int, rings:int):Vector.<Number>
        {
            var points:Vector.<Number> = new Vector.<Number>();
            for (var ring:int = 0; ring < rings; ring++)
            {
                for (var i:int = 0; i < segments; i++)
                {
                    var angle:Number = 2 * Math.PI * i / segments;
                    points.push(radius * Math.cos(angle), radius * Math.sin(angle), height * ring / (rings - 1));
                }
            }
            return points;
        }

        /** A sphere of meridians and parallels, with its two poles. */
        public static function sphere(radius:Number, meridians:int, parallels:int):Vector.<Number>
        {
            var points:Vector.<Number> = new <Number>[0, 0, -radius];
            for (var i:int = 1; i <= parallels; i++)
            {
                var polar:Number = Math.PI * i / (parallels + 1);
                for (var j:int = 0; j < meridians; j++)
                {
                    var angle:Number = 2 * Math.PI * j / meridians;
                    points.push(radius * Math.sin(polar) * Math.cos(angle), radius * Math.sin(polar) * Math.sin(angle),
                            -radius * Math.cos(polar));
                }
            }
            points.push(0, 0, radius);
            return points;
        }

        /** Random points in a box. */
        public static function cloud(random:SeededRandom, count:int, x:Number = 1, y:Number = 1, z:Number = 1):Vector.<Number>
        {
            var points:Vector.<Number> = new Vector.<Number>(3 * count);
            for (var i:int = 0; i < points.length; i += 3)
            {
                points[i] = x * random.between(-0.5, 0.5);
                points[i + 1] = y * random.between(-0.5, 0.5);
                points[i + 2] = z * random.between(-0.5, 0.5);
            }
            return points;
        }

        /** Random points on a sphere. */
        public static function shell(random:SeededRandom, count:int, radius:Number = 0.5):Vector.<Number>
        {
            var points:Vector.<Number> = new Vector.<Number>();
            for (var i:int = 0; i < count; i++)
            {
                var z:Number = random.between(-1, 1);
                var angle:Number = random.between(0, 2 * Math.PI);
                var across:Number = Math.sqrt(1 - z * z);
                points.push(radius * across * Math.cos(angle), radius * across * Math.sin(angle), radius * z);
            }
            return points;
        }

        /** The points in a random order. */
        public static function shuffled(points:Vector.<Number>, random:SeededRandom):Vector.<Number>
        {
            var mixed:Vector.<Number> = points.concat();
            for (var i:int = mixed.length / 3 - 1; i > 0; i--)
            {
                var j:int = random.integer(0, i);
                for (var k:int = 0; k < 3; k++)
                {
                    var swap:Number = mixed[3 * i + k];
                    mixed[3 * i + k] = mixed[3 * j + k];
                    mixed[3 * j + k] = swap;
                }
            }
            return mixed;
        }

        /** The points rotated at random. */
        public static function turned(points:Vector.<Number>, random:SeededRandom):Vector.<Number>
        {
            var w:Number = random.normal();
            var x:Number = random.normal();
            var y:Number = random.normal();
            var z:Number = random.normal();
            var length:Number = Math.sqrt(w * w + x * x + y * y + z * z);
            w /= length;
            x /= length;
            y /= length;
            z /= length;
            return mapped(points, new <Number>[1 - 2 * (y * y + z * z), 2 * (x * y - w * z), 2 * (x * z + w * y), 0,
                        2 * (x * y + w * z), 1 - 2 * (x * x + z * z), 2 * (y * z - w * x), 0,
                        2 * (x * z - w * y), 2 * (y * z + w * x), 1 - 2 * (x * x + y * y), 0]);
        }

        /** The points scaled and moved. */
        public static function placed(points:Vector.<Number>, scale:Number, x:Number = 0, y:Number = 0, z:Number = 0):Vector.<Number>
        {
            return mapped(points, new <Number>[scale, 0, 0, x, 0, scale, 0, y, 0, 0, scale, z]);
        }

        /** Each coordinate moved by up to this much. */
        public static function noisy(points:Vector.<Number>, random:SeededRandom, amount:Number):Vector.<Number>
        {
            var moved:Vector.<Number> = points.concat();
            for (var i:int = 0; i < moved.length; i++)
            {
                moved[i] += random.between(-amount, amount);
            }
            return moved;
        }

        /**
         * The sets on which anything can go wrong, small ones, by name.
         *
         * @return name, points, name, points, ...
         */
        public static function hard(random:SeededRandom):Array
        {
            var line:Vector.<Number> = cloud(random, 30, 1, 0, 0);
            var plane:Vector.<Number> = cloud(random, 60, 1, 0.7, 0);
            var cube:Vector.<Number> = box(0.5, 0.5, 0.5);
            var fineCube:Vector.<Number> = shuffled(box(0.5, 0.5, 0.5, 6), random);
            return [
                    "a point", new <Number>[1, 2, 3],
                    "a point five times", new <Number>[1, 2, 3, 1, 2, 3, 1, 2, 3, 1, 2, 3, 1, 2, 3],
                    "the origin", new <Number>[0, 0, 0],
                    "two points", new <Number>[1, 2, 3, -1, 0.5, 7],
                    "three points", new <Number>[1, 2, 3, -1, 0.5, 7, 0, 0, 1],
                    "four points", new <Number>[0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1],
                    "four points in a plane", new <Number>[0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 1, 0],
                    "a line along x", line,
                    "a line turned", turned(line, random),
                    "a line turned, far away", placed(turned(line, random), 1, 1000, -3000, 500),
                    "a plane", plane,
                    "a plane turned", turned(plane, random),
                    "a plane turned, far away", placed(turned(plane, random), 1, 1000, -3000, 500),
                    "a grid in a plane", turned(box(0.5, 0.5, 0, 7), random),
                    "a cube", cube,
                    "a cube, every vertex three times", cube.concat(cube, cube),
                    "a cube turned", turned(cube, random),
                    "a cube of 6 x 6 squares", fineCube,
                    "a cube of 6 x 6 squares turned", turned(fineCube, random),
                    "that with noise of 1e-15", noisy(turned(fineCube, random), random, 1e-15),
                    "that with noise of 1e-9", noisy(turned(fineCube, random), random, 1e-9),
                    "that with noise of 1e-7", noisy(turned(fineCube, random), random, 1e-7),
                    "that with noise of 1e-4", noisy(turned(fineCube, random), random, 1e-4),
                    "a sphere", sphere(0.5, 16, 9),
                    "a cylinder", cylinder(0.5, 1.131, 24, 5),
                    "a cylinder turned", turned(cylinder(0.5, 1.131, 24, 5), random),
                    "a needle", turned(cloud(random, 80, 1, 1e-4, 1e-4), random),
                    "a sheet", turned(cloud(random, 80, 1, 1, 1e-5), random),
                    "scaled badly", cloud(random, 80, 1e4, 1, 1e-4),
                    "scaled badly and turned", turned(cloud(random, 80, 1e4, 1, 1e-4), random),
                    "tiny", placed(cloud(random, 50), 1e-9),
                    "huge", placed(cloud(random, 50), 1e9),
                    "a cloud", cloud(random, 200),
                    "a shell", shell(random, 200)];
        }

        private static function mapped(points:Vector.<Number>, m:Vector.<Number>):Vector.<Number>
        {
            var result:Vector.<Number> = new Vector.<Number>(points.length);
            for (var i:int = 0; i < points.length; i += 3)
            {
                for (var row:int = 0; row < 3; row++)
                {
                    result[i + row] = m[4 * row] * points[i] + m[4 * row + 1] * points[i + 1] + m[4 * row + 2] * points[i + 2]
                        + m[4 * row + 3];
                }
            }
            return result;
        }
    }
}
