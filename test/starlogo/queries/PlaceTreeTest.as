package starlogo.queries
{
    import evaluation.pairs.SeededRandom;
    import org.flexunit.asserts.assertEquals;
    import org.flexunit.asserts.assertTrue;

    /** The tree of places against loops over all of them. */
    public class PlaceTreeTest
    {
        private var _random:SeededRandom;
        private var _x:Vector.<Number>;
        private var _y:Vector.<Number>;
        private var _z:Vector.<Number>;
        private var _rows:Vector.<int>;
        private var _tree:PlaceTree;

        [Before]
        public function begin():void
        {
            _random = new SeededRandom(811);
            _tree = new PlaceTree();
        }

        [Test]
        public function findsWhatALoopFinds():void
        {
            var foundSome:int = 0;
            var foundNone:int = 0;
            for (var world:int = 0; world < 120; world++)
            {
                makeWorld(world);
                _tree.build(_x, _y, _z, _rows, _rows.length);
                for (var i:int = 0; i < 30; i++)
                {
                    choosePlace(world);
                    assertLikeALoop("world " + world + ", " + i, null) ? foundSome++ : foundNone++;
                    assertLikeALoop("world " + world + ", some, " + i, new ThirdsTest());
                    if (_rows.length > 0)
                    {
                        moveOne(world);
                    }
                }
            }
            assertTrue(foundSome + " some, " + foundNone + " none", foundSome > 1000 && foundNone > 300);
        }

        private function makeWorld(world:int):void
        {
            _x = new Vector.<Number>();
            _y = new Vector.<Number>();
            _z = new Vector.<Number>();
            _rows = new Vector.<int>();
            var count:int = world % 10 == 0 ? world / 10 : _random.integer(1, 400);
            for (var i:int = 0; i < count; i++)
            {
                addPlace(world);
            }
            for (i = 0; i < count; i++)
            {
                if (i % 5 > 0 || count < 10)
                {
                    _rows.push(count - 1 - i);
                }
            }
        }

        private function addPlace(world:int):void
        {
            var at:int = _x.length;
            _x[at] = coordinate(world);
            _y[at] = coordinate(world);
            _z[at] = world % 3 == 0 ? 0 : coordinate(world);
        }

        // dense; on a grid, so that many are equally far; in one place; far out; over many orders
        private function coordinate(world:int):Number
        {
            switch (world % 6)
            {
                case 0:
                    return _random.between(-20, 20);
                case 1:
                    return _random.integer(-4, 4);
                case 2:
                    return _random.integer(0, 9) < 8 ? 7.25 : _random.between(0, 20);
                case 3:
                    return 1e9 + _random.between(-50, 50);
                case 4:
                    return _random.logBetween(1e-3, 1e6) * _random.pick([-1, 1]);
                default:
                    return _random.integer(0, 19) == 0 ? 1e7 * _random.between(-1, 1) : _random.between(-1, 1);
            }
        }

        private function choosePlace(world:int):void
        {
            _tree.x = coordinate(world);
            _tree.y = coordinate(world);
            _tree.z = world % 3 == 0 ? 0 : coordinate(world);
            var reach:Number = _random.pick([0, 1, 5, 30, 1e4, Infinity]);
            _tree.limit = reach * reach;
        }

        private function moveOne(world:int):void
        {
            var member:int = _random.integer(0, _rows.length - 1);
            var row:int = _rows[member];
            _tree.x = _x[row] = coordinate(world);
            _tree.y = _y[row] = coordinate(world);
            _tree.z = _z[row] = coordinate(world);
            _tree.move(member);
        }

        private function assertLikeALoop(message:String, test:RowTest):Boolean
        {
            var near:Vector.<int> = new Vector.<int>();
            var nearest:int = -1;
            var least:Number = Infinity;
            for (var i:int = 0; i < _rows.length; i++)
            {
                var square:Number = squareOf(i);
                if (square > _tree.limit || (test != null && !test.accepts(i)))
                {
                    continue;
                }
                near.push(i);
                if (nearest < 0 || square < least)
                {
                    nearest = i;
                    least = square;
                }
            }
            assertEquals(message + ": nearest", nearest, _tree.findNearest(test));
            assertEquals(message + ": count", near.length, _tree.countNear(test));
            var count:int = _tree.findNear(test);
            for (i = 0; i < count; i++)
            {
                assertEquals(message + ": distance", squareOf(_tree.found[i]), _tree.squares[i]);
            }
            var found:Vector.<int> = _tree.found.slice(0, count);
            found.sort(Array.NUMERIC);
            assertEquals(message, near.join(), found.join());
            return nearest >= 0;
        }

        private function squareOf(member:int):Number
        {
            var row:int = _rows[member];
            var x:Number = _x[row] - _tree.x;
            var y:Number = _y[row] - _tree.y;
            var z:Number = _z[row] - _tree.z;
            return x * x + y * y + z * z;
        }
    }
}

import starlogo.queries.RowTest;

class ThirdsTest extends RowTest
{
    override public function accepts(member:int):Boolean
    {
        return member % 3 == 1;
    }
}
