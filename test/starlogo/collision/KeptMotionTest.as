package starlogo.collision
{
    import org.flexunit.asserts.assertEquals;
    import org.flexunit.asserts.assertFalse;
    import org.flexunit.asserts.assertTrue;
    import starlogo.GreatLand;
    import starlogo.agents.Agent;
    import starlogo.models.BuiltInModel;
    import support.Complaints;
    import support.EachCollider;
    import support.assertThrows;
    import support.landOf;

    /**
     * An agent's motion since a collider's last frame is its own: neither models that come and go nor questions between two frames take any of it
     * away.
     */
    public class KeptMotionTest
    {
        private var _greatLand:GreatLand;
        private var _ball:Agent;
        private var _wall:Agent;
        private var _third:Agent;
        private var _agents:Vector.<Agent>;
        private var _wrong:Complaints;

        [Before]
        public function makeGame():void
        {
            _greatLand = landOf(BuiltInModel.sphere(), BuiltInModel.cube(), BuiltInModel.cylinder());
            _ball = new Agent("sphere", "balls");
            _ball.size = 0.2;
            _wall = new Agent("cube", "walls");
            _wall.moveTo(5, 0, 0);
            // no agent comes near it
            _third = new Agent("cube", "walls");
            _third.moveTo(5, 30, 0);
            _agents = new <Agent>[_ball, _wall, _third];
            _wrong = new Complaints();
        }

        [Test]
        public function noModelThatComesOrGoesEndsAMotion():void
        {
            kept("an unrelated model was removed", function(collider:Collider):void
                {
                    assertTrue(_greatLand.removeModel("cylinder"));
                    assertFalse(_greatLand.removeModel("unrelated"));
                });
            kept("an unrelated model was replaced", function(collider:Collider):void
                {
                    _greatLand.addModel(BuiltInModel.cylinder());
                });
            kept("the mover's own model was replaced by itself", function(collider:Collider):void
                {
                    _greatLand.addModel(BuiltInModel.sphere());
                });
            kept("the model of the agent that it hits was replaced", function(collider:Collider):void
                {
                    _greatLand.addModel(BuiltInModel.cube());
                });
            kept("models were removed and added again", function(collider:Collider):void
                {
                    _greatLand.removeModel("sphere");
                    _greatLand.removeModel("cube");
                    _greatLand.addModel(BuiltInModel.sphere());
                    _greatLand.addModel(BuiltInModel.cube());
                });
            kept("a structure and a tree were added to the libraries", function(collider:Collider):void
                {
                    _greatLand.boundingStructures.add("cylinder", BuiltInModel.cylinder().vertices);
                    _greatLand.hierarchies.add("cylinder", BuiltInModel.cylinder().vertices, BuiltInModel.cylinder().triangles);
                });
            kept("models were replaced, and the pair was asked about", function(collider:Collider):void
                {
                    _greatLand.addModel(BuiltInModel.cylinder());
                    _ball.moveTo(8, 0, 0.4);
                    collider.areColliding(_ball, _wall);
                    collider.contactOf(_ball, _wall);
                    _greatLand.addModel(BuiltInModel.sphere());
                });
            _wrong.assertNone();
        }

        [Test]
        public function motionGoesOnFrameByFrameWhileModelsAreReplacedInEveryFrame():void
        {
            for each (var name:String in EachCollider.NAMES)
            {
                var collider:Collider = EachCollider.make(name, _greatLand);
                _ball.sweeps = true;
                _ball.jumpTo(0, 0, 0.4);
                found(collider);
                var hits:String = "";
                for (var frame:int = 0; frame < 6; frame++)
                {
                    _greatLand.addModel(BuiltInModel.cylinder());
                    _ball.moveTo(frame % 2 == 0 ? 10 : 0, 0, 0.4);
                    hits += found(collider);
                }
                if (hits != "222222")
                {
                    _wrong.add(name, hits);
                }
            }
            _wrong.assertNone();
        }

        [Test]
        public function noQuestionEndsAMotion():void
        {
            kept("an agent that is not listed was asked about", function(collider:Collider):void
                {
                    var stranger:Agent = new Agent("cube");
                    stranger.moveTo(7, 0, 0);
                    _ball.moveTo(7, 0, 0.4);
                    assertTrue(collider.areColliding(stranger, _ball));
                    assertFalse(collider.areColliding(stranger, _wall));
                });
            kept("the pair was asked about many times", function(collider:Collider):void
                {
                    // past the wall without touching it in every question
                    for each (var x:Number in [1, 3, 4, 6, 8, 12])
                    {
                        _ball.moveTo(x, 0, 0.4);
                        assertFalse(collider.areColliding(_ball, _wall));
                        collider.contactOf(_wall, _ball);
                        assertFalse(collider.areColliding(_third, _ball));
                        collider.contactOf(_third, _ball);
                    }
                });
            kept("a question threw", function(collider:Collider):void
                {
                    _ball.moveTo(10, 0, 0.4);
                    assertThrows(ArgumentError, /nothing/, collider.areColliding, _ball, new Agent("nothing"));
                    assertThrows(ArgumentError, /nothing/, collider.areColliding, new Agent("nothing"), _ball);
                    assertThrows(ArgumentError, /two different agents/, collider.areColliding, _ball, _ball);
                });
            _wrong.assertNone();
        }

        [Test]
        public function questionsOfHandlersEndNoMotion():void
        {
            for each (var name:String in EachCollider.NAMES)
            {
                for each (var sweepsBefore:Boolean in [false, true])
                {
                    var collider:Collider = EachCollider.make(name, _greatLand);
                    var collision:Collision = new Collision(collider);
                    var hits:int = 0;
                    var thrower:Agent = new Agent("cube", "throwers");
                    thrower.moveTo(0, 0, 0);
                    _ball.sweeps = sweepsBefore;
                    _ball.jumpTo(0, 0, 0.4);
                    collision.onCollision("balls", "throwers", function(ball:Agent, other:Agent):void
                        {
                            ball.sweeps = true;
                            ball.moveTo(10, 0, 0.4);
                            assertFalse(collider.areColliding(ball, _wall));
                        });
                    collision.onCollision("balls", "walls", function(ball:Agent, wall:Agent):void
                        {
                            hits++;
                        });
                    collision.update(new <Agent>[_ball, _wall, thrower]);
                    assertEquals(0, hits);
                    collision.update(new <Agent>[_ball, _wall]);
                    if (hits != 1)
                    {
                        _wrong.add(name, hits + " hits");
                    }
                }
            }
            _wrong.assertNone();
        }

        [Test]
        public function aFrameThatThrowsIsPartOfTheMotion():void
        {
            kept("frames threw after the mover moved", function(collider:Collider):void
                {
                    _ball.moveTo(10, 0, 0.4);
                    assertThrows(ArgumentError, /nothing/, collider.findCollisions, _agents.concat(new <Agent>[new Agent("nothing")]));
                    assertThrows(ArgumentError, /twice/, collider.findCollisions, _agents.concat(new <Agent>[_third]));
                    assertThrows(ArgumentError, /twice/, collider.findCollisions, _agents.concat(new <Agent>[_ball]));
                    assertThrows(ArgumentError, /null/, collider.findCollisions, _agents.concat(new <Agent>[null]));
                    assertThrows(ArgumentError, /null/, collider.findCollisions, new <Agent>[null].concat(_agents));
                    assertThrows(ArgumentError, /null/, collider.findCollisions, null);
                    // in another order, with some that were listed before the one that is wrong
                    assertThrows(ArgumentError, /null/, collider.findCollisions, new <Agent>[_third, _ball, _wall, null]);
                    assertThrows(ArgumentError, /twice/, collider.findCollisions, new <Agent>[_wall, _ball, new Agent("cube"), _third, _wall]);
                });
            kept("frames threw, most without the mover", function(collider:Collider):void
                {
                    assertThrows(ArgumentError, /nothing/, collider.findCollisions, new <Agent>[_wall, new Agent("nothing")]);
                    assertThrows(ArgumentError, /listed twice/, collider.findCollisions, new <Agent>[_wall, _wall]);
                    assertThrows(ArgumentError, /null/, collider.findCollisions, new <Agent>[_ball, null]);
                    assertThrows(ArgumentError, /nothing/, collider.findCollisions, new <Agent>[new Agent("cube"), new Agent("nothing")]);
                });
            kept("the mover's model was gone for a frame", function(collider:Collider):void
                {
                    _ball.moveTo(10, 0, 0.4);
                    _greatLand.removeModel("sphere");
                    assertThrows(ArgumentError, /there is no model "sphere"/, collider.findCollisions, _agents);
                    _greatLand.addModel(BuiltInModel.sphere());
                });
            _wrong.assertNone();
        }

        [Test]
        public function jumpsOtherShapesAndFramesElsewhereEndAMotion():void
        {
            ended("a jump, and a model was replaced", function(collider:Collider):void
                {
                    _ball.jumpTo(10, 0, 0.4);
                    _greatLand.addModel(BuiltInModel.cylinder());
                });
            ended("a jump, and questions before and after a model was replaced", function(collider:Collider):void
                {
                    _ball.jumpTo(10, 0, 0.4);
                    assertFalse(collider.areColliding(_ball, _wall));
                    _greatLand.addModel(BuiltInModel.sphere());
                    assertFalse(collider.areColliding(_ball, _wall));
                });
            ended("a jump, and a frame threw", function(collider:Collider):void
                {
                    _ball.jumpTo(10, 0, 0.4);
                    assertThrows(ArgumentError, /nothing/, collider.findCollisions, _agents.concat(new <Agent>[new Agent("nothing")]));
                });
            ended("a jump away and one back", function(collider:Collider):void
                {
                    // back and forth: it is where it was, but it did not move there
                    _ball.jumpTo(-3, 0, 0.4);
                    _ball.jumpTo(0, 0, 0.4);
                });
            ended("another shape, and a model was replaced", function(collider:Collider):void
                {
                    _ball.shape = "cube";
                    _greatLand.addModel(BuiltInModel.cylinder());
                });
            ended("another shape, and a question", function(collider:Collider):void
                {
                    _ball.shape = "cube";
                    assertFalse(collider.areColliding(_ball, _wall));
                });
            ended("another shape, and a frame threw", function(collider:Collider):void
                {
                    _ball.shape = "cube";
                    assertThrows(ArgumentError, /twice/, collider.findCollisions, _agents.concat(new <Agent>[_third]));
                });
            ended("a frame without it, and a question", function(collider:Collider):void
                {
                    collider.findCollisions(new <Agent>[_wall, _third]);
                    assertFalse(collider.areColliding(_ball, _wall));
                });
            ended("a model was replaced, and a frame without it", function(collider:Collider):void
                {
                    _greatLand.addModel(BuiltInModel.cylinder());
                    collider.findCollisions(new <Agent>[_third, _wall]);
                });
            ended("an empty frame", function(collider:Collider):void
                {
                    collider.findCollisions(new Vector.<Agent>());
                });
            _wrong.assertNone();
        }

        [Test]
        public function whoseModelWasLoadingHasNoMotion():void
        {
            for each (var name:String in EachCollider.NAMES)
            {
                var collider:Collider = EachCollider.make(name, _greatLand);
                _greatLand.removeModel("sphere");
                _greatLand.expect("sphere");
                _ball.sweeps = true;
                _ball.jumpTo(0, 0, 0.4);
                assertEquals(0, found(collider));
                assertEquals(1, collider.statistics.agentsLoading);
                _greatLand.addModel(BuiltInModel.sphere());
                _greatLand.expectNoMore("sphere");
                _ball.moveTo(10, 0, 0.4);
                if (found(collider) != 0)
                {
                    _wrong.add(name, "found");
                }
                _ball.moveTo(0, 0, 0.4);
                assertEquals(name + ": from now on", 2, found(collider));
            }
            _wrong.assertNone();
        }

        // Whatever happens between two frames, the wall between the places of the ball is met once: whether an agent swept before or not.
        private function kept(cause:String, happens:Function):void
        {
            forEach(cause, happens, function(collider:Collider, what:String):void
                {
                    if (found(collider) != 2)
                    {
                        _wrong.add(what, "missed");
                        return;
                    }
                    var time:Number = collider.contactOf(_ball, _wall).time;
                    assertTrue(what + " at " + time, Math.abs(time - 0.44) < 1e-9);
                    assertEquals(what + ": once", 0, found(collider));
                });
        }

        // Whatever happens between two frames, the wall is not met on a motion that has ended.
        private function ended(cause:String, happens:Function):void
        {
            forEach(cause, happens, function(collider:Collider, what:String):void
                {
                    if (found(collider) != 0)
                    {
                        _wrong.add(what, "found");
                    }
                    _ball.moveTo(0, 0, 0.4);
                    assertEquals(what + ": the next one", 2, found(collider));
                });
        }

        private function forEach(cause:String, happens:Function, check:Function):void
        {
            for each (var name:String in EachCollider.NAMES)
            {
                for each (var sweepsBefore:Boolean in [true, false])
                {
                    var collider:Collider = newCollider(name, sweepsBefore);
                    happens(collider);
                    _ball.sweeps = true;
                    _ball.moveTo(10, 0, 0.4);
                    check(collider, cause + ", " + name + (sweepsBefore ? "" : ", after a frame in which no agent sweeps"));
                }
            }
        }

        private function newCollider(name:String, sweepsBefore:Boolean):Collider
        {
            if (!_greatLand.hasModel("cylinder"))
            {
                _greatLand.addModel(BuiltInModel.cylinder());
            }
            var collider:Collider = EachCollider.make(name, _greatLand);
            _ball.shape = "sphere";
            _ball.sweeps = sweepsBefore;
            _ball.jumpTo(0, 0, 0.4);
            assertEquals(name + " before", 0, found(collider));
            return collider;
        }

        private function found(collider:Collider):int
        {
            return collider.findCollisions(_agents).length;
        }
    }
}
