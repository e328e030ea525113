class_name OwnBankShot
extends OwnPicture
## How the ball flies that starts in the student's direction: as long as the lab's own, and off all
## walls.


## His methods know of one bounce, or of two with C = 1, off lines of which start and target are on
## the same side.
func questions(state: Dictionary) -> Array[OwnQuestion]:
	var model := BankShotModel.new()
	model.from_dictionary(state)
	var board := model.board
	if board.bounces > 2 or board.bounces == 2 and board.bounciness < 1.0:
		return []
	var answer := model.answer()
	if answer.way.images.is_empty() or answer.overlapped >= 0 or not _is_beside(answer.way, board):
		return []
	var asked := pair(board.start) + pair(board.target)
	asked.append(board.radius)
	if board.bounces == 1:
		asked.append(board.bounciness)
	for place in answer.way.walls:
		asked += pair(board.walls[place].start) + pair(board.walls[place].end)
	var method := "bank" if board.bounces == 1 else "bank_twice"
	var way := func(direction: PackedFloat64Array) -> OwnMark:
		return _way(answer, board.start, vector(direction).normalized())
	return [OwnQuestion.new(method, asked, "d", board.start, way).told_by(no_shot)]


# Whether the ball bounces on that side of each wall on which it starts.
static func _is_beside(way: BankWay, board: BankBoard) -> bool:
	for bounce in way.walls.size():
		var wall := board.walls[way.walls[bounce]]
		if wall.normal().dot(board.start.minus(wall.start)) * way.sides[bounce] <= 0.0:
			return false
	return true


static func _way(answer: BankShotAnswer, start: Vec2, direction: Vec2) -> OwnMark:
	if direction.length() == 0.0:
		return OwnMark.note(start)
	return OwnMark.way(answer.shot(direction).corners(BankShotAnswer.SECONDS))
