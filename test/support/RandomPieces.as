package support
{
    import evaluation.pairs.SeededRandom;
    import starlogo.models.BuiltInModel;
    import starlogo.models.Model;

    /** A random model of closed pieces, and of triangles that close nothing; and what is inside of it, found piece by piece. */
    public final class RandomPieces
    {
        /** x, y, z of each vertex. */
        public var vertices:Vector.<Number> = new Vector.<Number>();

        /** The triangles of all pieces, and the others. */
        public var triangles:Vector.<uint> = new Vector.<uint>();

        private var _random:SeededRandom;
        private var _lists:Array = [];

        // Of each piece: its model, right side out; whether it is turned inside out; the number of the piece in which it bounds a cavity, or -1.
        private var _models:Array = [];
        private var _isTurned:Array = [];
        private var _shells:Array = [];

        public function RandomPieces(random:SeededRandom)
        {
            _random = random;
            for (var i:int = random.integer(1, 5); i > 0; i--)
            {
                addPiece();
            }
            for (i = random.integer(0, 2); i > 0; i--)
            {
                addOddTriangle();
            }
            for (i = random.integer(0, 1) * _lists.length; i > 1; i--)
            {
                var swap:int = random.integer(0, i - 1);
                var list:Array = _lists[i - 1];
                _lists[i - 1] = _lists[swap];
                _lists[swap] = list;
            }
            for each (list in _lists)
            {
                triangles.push(list[0], list[1], list[2]);
            }
            findShells();
        }

        /** A point near a piece. */
        public function nearPoint():Array
        {
            var bounds:Vector.<Number> = Surfaces.bounds(_random.pick(_models).vertices);
            var point:Array = [];
            for (var axis:int = 0; axis < 3; axis++)
            {
                point.push(bounds[axis] + (bounds[3 + axis] - bounds[axis]) * _random.between(-0.1, 1.1));
            }
            return point;
        }

        /** Whether a point is inside of a piece that is solid, and not in a cavity of it. */
        public function contains(at:Array):Boolean
        {
            for (var i:int = 0; i < _models.length; i++)
            {
                var isInside:Boolean = _shells[i] < 0 && isIn(_models[i], at);
                for (var k:int = 0; k < _models.length && isInside; k++)
                {
                    isInside = _shells[k] != i || !isIn(_models[k], at);
                }
                if (isInside)
                {
                    return true;
                }
            }
            return false;
        }

        private static function isIn(model:Model, at:Array):Boolean
        {
            return Math.abs(SolidAngles.windingAround(model, at[0], at[1], at[2])) > 0.5;
        }

        // A cube or a ball on a grid, so that many share faces, edges and corners; or a smaller one within the last piece.
        private function addPiece():void
        {
            var shape:Model = _random.next() < 0.6 ? BuiltInModel.cube() : BuiltInModel.sphere();
            var size:Number = _random.integer(2, 8) / 8;
            var place:Array = [_random.integer(-4, 4) / 8, _random.integer(-4, 4) / 8, _random.integer(0, 4) / 8];
            if (_models.length > 0 && _random.next() < 0.3)
            {
                var bounds:Vector.<Number> = Surfaces.bounds(_models[_models.length - 1].vertices);
                size = 0.5 * (bounds[3] - bounds[0]);
                place = [(bounds[0] + bounds[3]) / 2, (bounds[1] + bounds[4]) / 2, bounds[2] + 0.25 * (bounds[5] - bounds[2])];
            }
            var isTurned:Boolean = _random.next() < 0.4;
            var isSplit:Boolean = _random.next() < 0.5;
            var own:Vector.<Number> = new Vector.<Number>();
            for (var i:int = 0; i < shape.vertices.length; i++)
            {
                own.push(size * shape.vertices[i] + place[i % 3]);
            }
            var first:int = vertices.length / 3;
            if (!isSplit)
            {
                vertices = vertices.concat(own);
            }
            for (i = 0; i < shape.triangles.length; i += 3)
            {
                var list:Array = [];
                for each (var corner:int in isTurned ? [0, 2, 1] : [0, 1, 2])
                {
                    var at:int = shape.triangles[i + corner];
                    list.push(isSplit ? vertices.length / 3 : first + at);
                    if (isSplit)
                    {
                        vertices.push(own[3 * at], own[3 * at + 1], own[3 * at + 2]);
                    }
                }
                _lists.push(list);
            }
            _models.push(new Model("piece " + _models.length, own, shape.triangles, Model.AS_GIVEN));
            _isTurned.push(isTurned);
        }

        // A triangle beside all others, one at an edge, or a copy, which may be turned.
        private function addOddTriangle():void
        {
            var list:Array = _random.pick(_lists);
            var kind:int = _random.integer(0, 3);
            var first:int = vertices.length / 3;
            for (var i:int = 0; i < 9; i++)
            {
                vertices.push(_random.between(-1, 1));
            }
            _lists.splice(_random.integer(0, 1) * _lists.length, 0, kind == 0 ? [first, first + 1, first + 2] : (kind == 1 ? [list[0], list[1], first]
                        : (kind == 2 ? list.concat() : [list[1], list[0], list[2]])));
        }

        // The largest pieces come first. A piece bounds a cavity in the smallest piece around it if that one is solid and turned otherwise.
        private function findShells():void
        {
            var sizes:Array = [];
            for each (var model:Model in _models)
            {
                sizes.push(-Surfaces.volume(model));
                _shells.push(-1);
            }
            var order:Array = sizes.sort(Array.NUMERIC | Array.RETURNINDEXEDARRAY);
            for each (var inner:int in order)
            {
                var innermost:int = -1;
                for each (var outer:int in order)
                {
                    if (sizes[outer] < 1.000001 * sizes[inner] && isWithin(_models[inner], _models[outer]))
                    {
                        innermost = outer;
                    }
                }
                if (innermost >= 0 && _shells[innermost] < 0 && _isTurned[innermost] != _isTurned[inner])
                {
                    _shells[inner] = innermost;
                }
            }
        }

        // Tests points a little inside of the inner piece: at each corner of a triangle, moved towards the middle of both.
        private static function isWithin(inner:Model, outer:Model):Boolean
        {
            var bounds:Vector.<Number> = Surfaces.bounds(inner.vertices);
            for (var i:int = 0; i < inner.vertices.length; i += 3)
            {
                var at:Array = [];
                for (var axis:int = 0; axis < 3; axis++)
                {
                    at.push(0.9999 * inner.vertices[i + axis] + 0.00005 * (bounds[axis] + bounds[3 + axis]));
                }
                if (!isIn(outer, at))
                {
                    return false;
                }
            }
            return true;
        }
    }
}
