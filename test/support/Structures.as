package support
{
    import evaluation.pairs.RandomStructures;
    import evaluation.pairs.SeededRandom;
    import flash.geom.Matrix3D;
    import flash.geom.Vector3D;
    import flash.utils.ByteArray;
    import starlogo.bounding.BoundingStructure;
    import starlogo.bounding.Box;
    import starlogo.bounding.Capsule;
    import starlogo.bounding.Cylinder;
    import starlogo.bounding.Hull;
    import starlogo.bounding.Sphere;

    /** What tests of bounding structures share. */
    public final class Structures
    {
        /** One of each kind, away from the origin and askew. */
        public static function samples():Vector.<BoundingStructure>
        {
            return Vector.<BoundingStructure>([
                        new Sphere(new Vector3D(1, -2, 0.5), 1.5),
                        new Capsule(new Vector3D(1, 2, 3), new Vector3D(-1, 2.5, 4), 0.75),
                        new Box(new Vector3D(0.5, -1, 2), new Vector3D(0.6, 0.8, 0), new Vector3D(-0.8, 0.6, 0),
                            new Vector3D(0, 0, 1), 1, 2, 0.5),
                        new Cylinder(new Vector3D(0, -1, 0.5), new Vector3D(2, 1, 1.5), 0.8),
                        new Hull(new <Number>[1, 2, 3, -1, 2.5, 2, 0, 0, 3.5, 2, 1, 1, 0.5, 3, 1.5, 0, 1, 0.5, 1, 0.5, 4])]);
        }

        /** Everything that makes a structure up, to compare two by. */
        public static function numbersOf(structure:BoundingStructure):Array
        {
            if (structure is Sphere)
            {
                var sphere:Sphere = Sphere(structure);
                return numbers([sphere.center]).concat(sphere.radius);
            }
            if (structure is Capsule)
            {
                var capsule:Capsule = Capsule(structure);
                return numbers([capsule.start, capsule.end]).concat(capsule.radius);
            }
            if (structure is Cylinder)
            {
                var cylinder:Cylinder = Cylinder(structure);
                return numbers([cylinder.start, cylinder.end]).concat(cylinder.radius);
            }
            if (structure is Hull)
            {
                var hull:Hull = Hull(structure);
                return numbers([hull.center]).concat(listOf(hull.corners), listOf(hull.faces));
            }
            var box:Box = Box(structure);
            return numbers([box.center, box.axisX, box.axisY, box.axisZ]).concat(box.halfX, box.halfY, box.halfZ);
        }

        /** A point of a structure: evenly spread directions, as far out as the surface where <code>depth</code> is 1. */
        public static function pointOf(structure:BoundingStructure, random:SeededRandom, depth:Number):Vector3D
        {
            var direction:Vector3D = new RandomStructures(random).direction();
            if (structure is Sphere)
            {
                return along(Sphere(structure).center, direction, depth * Sphere(structure).radius);
            }
            if (structure is Capsule)
            {
                var capsule:Capsule = Capsule(structure);
                var middle:Vector3D = between(capsule.start, capsule.end, random.pick([0, 1, random.next()]));
                return along(middle, direction, depth * capsule.radius);
            }
            if (structure is Cylinder)
            {
                var cylinder:Cylinder = Cylinder(structure);
                var across:Vector3D = direction.crossProduct(cylinder.end.subtract(cylinder.start));
                across.normalize();
                middle = between(cylinder.start, cylinder.end, random.pick([0, 1, random.next()]));
                return along(middle, across, depth * cylinder.radius);
            }
            if (structure is Hull)
            {
                return pointOfHull(Hull(structure), random, depth);
            }
            var box:Box = Box(structure);
            var point:Vector3D = along(box.center, box.axisX, depth * box.halfX * random.pick([-1, 1, random.between(-1, 1)]));
            point = along(point, box.axisY, depth * box.halfY * random.pick([-1, 1, random.between(-1, 1)]));
            return along(point, box.axisZ, depth * box.halfZ * random.pick([-1, 1]));
        }

        // On a face, an edge or a corner, or between it and the centre.
        private static function pointOfHull(hull:Hull, random:SeededRandom, depth:Number):Vector3D
        {
            var face:int = 3 * random.integer(0, hull.faces.length / 3 - 1);
            var a:Vector3D = cornerOf(hull, face);
            var b:Vector3D = cornerOf(hull, face + 1);
            var c:Vector3D = cornerOf(hull, face + 2);
            var point:Vector3D = between(between(a, b, random.pick([0, random.next()])), c, random.pick([0, random.next()]));
            return between(hull.center, point, depth);
        }

        private static function cornerOf(hull:Hull, i:int):Vector3D
        {
            var at:int = 3 * hull.faces[i];
            return new Vector3D(hull.corners[at], hull.corners[at + 1], hull.corners[at + 2]);
        }

        /** A matrix as Flash Player has it: its numbers rounded to single precision. */
        public static function inSinglePrecision(matrix:Matrix3D):Matrix3D
        {
            var rounded:Vector.<Number> = matrix.rawData;
            for (var i:int = 0; i < rounded.length; i++)
            {
                rounded[i] = singlePrecision(rounded[i]);
            }
            return new Matrix3D(rounded);
        }

        /** A vector with its components rounded to single precision. */
        public static function vectorInSinglePrecision(vector:Vector3D):Vector3D
        {
            return new Vector3D(singlePrecision(vector.x), singlePrecision(vector.y), singlePrecision(vector.z));
        }

        private static var sBytes:ByteArray = new ByteArray();

        private static function singlePrecision(value:Number):Number
        {
            sBytes.position = 0;
            sBytes.writeFloat(value);
            sBytes.position = 0;
            return sBytes.readFloat();
        }

        private static function listOf(vector:*):Array
        {
            var list:Array = [];
            for each (var number:Number in vector)
            {
                list.push(number);
            }
            return list;
        }

        private static function numbers(vectors:Array):Array
        {
            var list:Array = [];
            for each (var vector:Vector3D in vectors)
            {
                list.push(vector.x, vector.y, vector.z);
            }
            return list;
        }

        private static function along(from:Vector3D, direction:Vector3D, distance:Number):Vector3D
        {
            return new Vector3D(
                    from.x + distance * direction.x, from.y + distance * direction.y, from.z + distance * direction.z);
        }

        private static function between(start:Vector3D, end:Vector3D, t:Number):Vector3D
        {
            return along(start, end.subtract(start), t);
        }
    }
}
